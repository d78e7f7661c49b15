option(ODDITY_FAST_BUILD "Compile small files together and shared headers once: to build all, not to edit" OFF)

# In a fast build, a library lists its objects where they are, and does not copy them.
if(ODDITY_FAST_BUILD)
  execute_process(COMMAND ${CMAKE_AR} --version OUTPUT_VARIABLE archiver ERROR_QUIET)
  if(archiver MATCHES "^GNU ar")
    set(CMAKE_CXX_ARCHIVE_CREATE "<CMAKE_AR> qc --thin <TARGET> <LINK_FLAGS> <OBJECTS>")
  endif()
endif()

# In a fast build, links a program by lld if it is installed. Not for programs that compute: of several copies of an
# inline function, lld may take one that is less optimized.
function(link_fast target)
  find_program(LLD ld.lld)
  mark_as_advanced(LLD)
  if(ODDITY_FAST_BUILD AND LLD AND NOT CMAKE_INTERPROCEDURAL_OPTIMIZATION)
    target_link_options(${target} PRIVATE -fuse-ld=lld)
  endif()
endfunction()

# In a fast build, compiles these headers of a target once, or takes those compiled before: REUSE_FROM target.
function(compile_headers_once target)
  if(NOT ODDITY_FAST_BUILD)
    return()
  endif()
  if(ARGV1 STREQUAL REUSE_FROM)
    target_precompile_headers(${target} ${ARGN})
  else()
    target_precompile_headers(${target} PRIVATE ${ARGN})
  endif()
endfunction()

# In a fast build, compiles a target's small files together, by UNITY_GROUP or by number.
function(compile_files_together target mode)
  set_target_properties(${target} PROPERTIES
    UNITY_BUILD ${ODDITY_FAST_BUILD} UNITY_BUILD_MODE ${mode} UNITY_BUILD_BATCH_SIZE 16)
endfunction()
# Assigns these files to a fixed number of groups, each by its own name, so that a new file changes one group.
function(group_by_name name groups)
  foreach(file IN LISTS ARGN)
    cmake_path(GET file FILENAME digits)
    string(MD5 digits ${digits})
    string(SUBSTRING ${digits} 0 4 digits)
    math(EXPR group "0x${digits} % ${groups}")
    set_source_files_properties(${file} PROPERTIES UNITY_GROUP ${name}_${group})
  endforeach()
endfunction()
