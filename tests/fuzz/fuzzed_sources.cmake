# What is fuzzed of modules and of the program, which no library has.
set(FUZZED_SOURCES ${CMAKE_SOURCE_DIR}/tests/files/files.cpp)
foreach(NAME dicom_structure dicom_plain dicom_runs dicom_codestream)
  list(APPEND FUZZED_SOURCES ${CMAKE_SOURCE_DIR}/render/readers/${NAME}.cpp)
endforeach()
foreach(NAME config_file recovery_text studio_settings user_folders)
  list(APPEND FUZZED_SOURCES ${CMAKE_SOURCE_DIR}/app/${NAME}.cpp)
endforeach()
