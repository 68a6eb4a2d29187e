# cmake -D BUILD=... -D STAGE=... -P install.cmake: a fresh installation of BUILD in STAGE.
file(REMOVE_RECURSE ${STAGE} ${BUILD}/consumer)
execute_process(COMMAND ${CMAKE_COMMAND} --install ${BUILD} --prefix ${STAGE} COMMAND_ERROR_IS_FATAL ANY)
