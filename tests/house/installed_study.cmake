# cmake -D PROGRAM=... -D FOLDER=... -P installed_study.cmake: writes an example of a study, with its case and its record,
# by a program that was installed, and runs it.
file(REMOVE_RECURSE ${FOLDER})
file(MAKE_DIRECTORY ${FOLDER})
foreach(arguments "example m12-gaps -o ${FOLDER}/mine" "sweep mine/m12-gaps.toml -o gaps.nc")
  separate_arguments(arguments)
  execute_process(COMMAND ${PROGRAM} ${arguments} WORKING_DIRECTORY ${FOLDER} COMMAND_ERROR_IS_FATAL ANY)
endforeach()
