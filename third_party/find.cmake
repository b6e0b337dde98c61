# find_package for the whole project, with one clear sentence when something is missing.
macro(crest_find NAME VERSION)
  find_package(${NAME} ${VERSION} QUIET GLOBAL)
  if(NOT ${NAME}_FOUND)
    message(FATAL_ERROR "${NAME} ${VERSION} or newer was not found: ./studio and ./check install it (third_party/packages.txt)")
  endif()
endmacro()
