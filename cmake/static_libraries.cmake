# unstep_link_static(program): links the static forms of what reads images and of
# the C++ library, if all of them are there: of the time in which the program
# starts, half goes into loading 19 shared libraries. They stand before the
# shared ones, which then have nothing left to resolve and are dropped.
function(unstep_link_static program)
  set(static_libraries)
  # Each before those that it needs.
  foreach(library png16 tiff webp zstd lzma Lerc jbig jpeg deflate minizip
      pugixml z)
    find_library(UNSTEP_STATIC_${library} lib${library}.a)
    mark_as_advanced(UNSTEP_STATIC_${library})
    if(NOT UNSTEP_STATIC_${library})
      message(STATUS
        "${program} links shared libraries: there is no lib${library}.a")
      target_link_libraries(${program} PRIVATE fmt::fmt)
      return()
    endif()
    list(APPEND static_libraries ${UNSTEP_STATIC_${library}})
  endforeach()
  target_link_libraries(${program} PRIVATE ${static_libraries}
    fmt::fmt-header-only)
  target_link_options(${program} PRIVATE -static-libstdc++ -static-libgcc
    -Wl,--as-needed -Wl,--gc-sections)
endfunction()
