# The refused cases, of which the repository has bases and changes: one file each, in tests/bad_input of the build folder.
find_package(Python3 REQUIRED COMPONENTS Interpreter)
set(refused ${PROJECT_SOURCE_DIR}/tests/bad_input)
file(GLOB refused_files CONFIGURE_DEPENDS ${refused}/* ${refused}/base/*)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${refused_files})
execute_process(COMMAND ${Python3_EXECUTABLE} ${refused}/expand.py ${refused} ${PROJECT_BINARY_DIR}/tests/bad_input
                COMMAND_ERROR_IS_FATAL ANY)
