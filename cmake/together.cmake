# unstep_compile_together(target group file...): under development these files
# of the target, patterns among them, become one translation unit: most of the
# time of a small file goes into the headers. Names in anonymous namespaces of
# a group differ. Of groups that a file is in, the last holds; without one it
# is compiled alone. A release compiles every file alone, so that a missing
# include is noticed.
function(unstep_compile_together target group)
  if(CMAKE_BUILD_TYPE STREQUAL "Dev")
    list(TRANSFORM ARGN PREPEND ${CMAKE_CURRENT_SOURCE_DIR}/)
    file(GLOB sources CONFIGURE_DEPENDS ${ARGN})
    set_source_files_properties(${sources} TARGET_DIRECTORY ${target}
      PROPERTIES UNITY_GROUP ${group})
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON
      UNITY_BUILD_MODE GROUP)
  endif()
endfunction()
