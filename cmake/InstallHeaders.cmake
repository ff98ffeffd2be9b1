# SPDX-License-Identifier: GPL-2.0-or-later
# cmake -D source=CORE -D output=DIR -D "folders=a;b/c" -P InstallHeaders.cmake: copies the headers of these folders of
# CORE. In the copies, #include "a/x.hpp" is #include <flowslide/a/x.hpp>, the path of an installed header.
file(REMOVE_RECURSE ${output})
foreach(folder IN LISTS folders)
  file(GLOB headers RELATIVE ${source} ${source}/${folder}/*.hpp)
  list(REMOVE_ITEM headers record/build_information.hpp)  # it includes a file of the build
  foreach(header IN LISTS headers)
    file(READ ${source}/${header} text)
    string(REGEX REPLACE "(#[ \t]*include[ \t]+)\"([^\"\n]+)\"" "\\1<flowslide/\\2>" text "${text}")
    file(WRITE ${output}/${header} "${text}")
  endforeach()
endforeach()
