# SPDX-License-Identifier: GPL-2.0-or-later
# Runs one hard scene and checks its claim: a trial that is silently wrong, or refused needlessly, fails the test.
set(arguments --config ${configuration} --output ${output} --point ${scene})
execute_process(COMMAND ${program} ${arguments} COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${program} ${arguments} --check RESULT_VARIABLE code)
file(READ ${output}/${scene}.md trials)
message(STATUS "${trials}")
if(NOT code EQUAL 0)
  message(FATAL_ERROR "the scene ${scene} has failed (exit code ${code}): see its trials above")
endif()
