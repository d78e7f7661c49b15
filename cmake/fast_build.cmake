option(ODDITY_FAST_BUILD "Compile small files together and shared headers once: to build all, not to edit" OFF)

# In a fast build, compiles these headers of a target once.
function(compile_headers_once target)
  if(ODDITY_FAST_BUILD)
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
