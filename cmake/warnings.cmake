# unstep_warnings(target): the warnings every target of the project has.
function(unstep_warnings target)
  target_compile_options(${target} PRIVATE
    -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Wsign-conversion
    $<$<BOOL:${UNSTEP_WERROR}>:-Werror>)
endfunction()
