# SPDX-License-Identifier: GPL-2.0-or-later
# Lets a case evaluate its claims, by an engine of its own if `engine` names one. Passes when the case could evaluate
# them, whether they are met or not.
set(options "")
if(engine)
  set(options --engine ${engine})
endif()
execute_process(COMMAND ${program} ${options} --output ${output} --check RESULT_VARIABLE code)
if(NOT code EQUAL 0 AND NOT code EQUAL 4)
  message(FATAL_ERROR "${program} --check ended with ${code}")
endif()
