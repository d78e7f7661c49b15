# Finds sources in folders and algorithms in a list. Rejects misplaced ones, which would be silently missing
# from the registers.

# Rejects an exercise's folder that has sources and no exercise.cpp: they would be missing from the registers.
function(require_exercises)
  foreach(file IN LISTS ARGN)
    cmake_path(GET file PARENT_PATH folder)
    if(folder MATCHES "/[0-9][0-9]_[^/]*/[0-9][0-9]_[^/]*$" AND NOT EXISTS ${folder}/exercise.cpp)
      file(GLOB names RELATIVE ${folder} ${folder}/*.cpp)
      list(JOIN names ", " names)
      message(FATAL_ERROR "${folder}: an exercise is defined in its folder's exercise.cpp, and this has ${names} alone")
    endif()
  endforeach()
endfunction()

# Rejects a folder whose name has characters special to CMake, that does not exist, or that has misplaced
# exercises.
function(require_own home)
  if("${home}" MATCHES "[][*?$\"\\,|\t\r\n]")
    message(FATAL_ERROR "ODDITY_OWN: the folder ${home} has a character in its name that CMake takes for more than "
      "itself, one of [ ] * ? $ \" \\ , | or the end of a line: rename it, or name a link to it")
  endif()
  if(NOT IS_DIRECTORY "${home}")
    message(FATAL_ERROR "ODDITY_OWN: ${home} is no folder")
  endif()
  file(GLOB elsewhere CONFIGURE_DEPENDS ${home}/exercise.cpp ${home}/*/exercise.cpp ${home}/[0-9][0-9]_*/*/exercise.cpp)
  file(GLOB_RECURSE inside CONFIGURE_DEPENDS ${home}/chapters/*.cpp)
  list(FILTER inside EXCLUDE REGEX "/chapters/[^/]*/[^/]*/[^/]*$")
  foreach(file IN LISTS elsewhere inside)
    message(FATAL_ERROR "ODDITY_OWN: ${file} is not compiled: an exercise is FOLDER/chapters/NN_topic/MM_slug/exercise.cpp, "
      "with its other sources beside it, and ODDITY_OWN names FOLDER")
  endforeach()
endfunction()

# Finds `own_exercises` in these folders, their other sources `own_sources`, and `own_generators`: the generators
# with their shared sources.
macro(find_own)
  set(own_exercises "")
  set(own_sources "")
  set(own_generators "")
  foreach(home ${ARGN})
    file(GLOB exercises CONFIGURE_DEPENDS ${home}/chapters/*/*/exercise.cpp)
    file(GLOB sources CONFIGURE_DEPENDS ${home}/chapters/*/*/*.cpp)
    file(GLOB generators CONFIGURE_DEPENDS ${home}/reference/make/*.cpp)
    require_exercises(${sources})
    if(exercises)
      list(REMOVE_ITEM sources ${exercises})
    endif()
    # For these files only, so that no other is recompiled because of them.
    set_source_files_properties(${exercises} ${sources} ${generators} PROPERTIES INCLUDE_DIRECTORIES "${home}")
    list(APPEND own_exercises ${exercises})
    list(APPEND own_sources ${sources})
    list(APPEND own_generators ${generators})
  endforeach()
endmacro()

# Lists the entries F(Algorithm, header) of a header as `output`. Rejects malformed entries.
function(list_algorithms output file)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${file})
  file(READ ${file} text)
  # Replaces characters that are special in CMake lists.
  string(REGEX REPLACE "[][;]" "_" text "${text}")
  string(REGEX MATCHALL "[^\n]*\n" lines "${text}")
  set(entries "")
  set(nth 0)
  foreach(line IN LISTS lines)
    math(EXPR nth "${nth} + 1")
    if(line MATCHES "^[ \t]*F[(]")
      if(NOT line MATCHES "^[ \t]*F[(]([A-Za-z0-9]+, [a-z0-9_]+)[)][ \t]*[\\]?[ \t]*\n$")
        message(FATAL_ERROR "${file}:${nth}: an algorithm is F(Algorithm, header), alone in its line")
      endif()
      list(APPEND entries "F(${CMAKE_MATCH_1})")
    endif()
  endforeach()
  set(${output} ${entries} PARENT_SCOPE)
endfunction()
