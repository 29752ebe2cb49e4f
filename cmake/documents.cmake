# cmake -D PROGRAM=… -D DIRECTORY=… -D REFERENCE=… -P documents.cmake
# Writes what the program says of itself: manual pages, completion for the shells, and the schema of a line of a batch.
# Beside them is a link to the reference collection.
cmake_minimum_required(VERSION 3.25)

function(write file)
  execute_process(COMMAND ${PROGRAM} ${ARGN}
    OUTPUT_VARIABLE text COMMAND_ERROR_IS_FATAL ANY)
  file(WRITE ${DIRECTORY}/${file} "${text}")
endfunction()

file(REMOVE_RECURSE ${DIRECTORY})
execute_process(COMMAND ${PROGRAM} help --json
  OUTPUT_VARIABLE list COMMAND_ERROR_IS_FATAL ANY)
write(man/man1/phrame.1 man)
string(JSON count LENGTH "${list}" commands)
math(EXPR last "${count} - 1")
foreach(k RANGE ${last})
  string(JSON command GET "${list}" commands ${k} command)
  write(man/man1/phrame-${command}.1 man ${command})
endforeach()
write(bash-completion/completions/phrame completion bash)
write(zsh/site-functions/_phrame completion zsh)
write(fish/vendor_completions.d/phrame.fish completion fish)
write(phrame/schema/line.json help --schema)
file(CREATE_LINK ${REFERENCE} ${DIRECTORY}/phrame/reference SYMBOLIC)  # where the program looks for it
