# The scenes' models in lanes: their headers compiled for each instruction set, a few scenes to a file, and the
# register of them. Nothing but the register knows of these files, which share no inline function.

set(lanes ${PROJECT_BINARY_DIR}/lanes)
set(lanes_sets One Baseline)
if(CMAKE_SYSTEM_PROCESSOR MATCHES "^(x86_64|AMD64|amd64)$" AND NOT CMAKE_BUILD_TYPE STREQUAL Mutated)
  list(APPEND lanes_sets Avx2 Avx512)
endif()
set(lanes_flags_Avx2 -mavx2)
set(lanes_flags_Avx512 -mavx512f -mavx512dq -mavx512vl -mavx512bw)
set(lanes_level -O2)
if(CMAKE_BUILD_TYPE STREQUAL "Mutated")
  set(lanes_level -O0)  # as the suite has no lanes
endif()
# Else g++ copies states of a few registers by `rep movs`, which takes longer than many a right-hand side.
set(lanes_options "")
if(CMAKE_SYSTEM_PROCESSOR MATCHES "^(x86_64|AMD64|amd64)$" AND CMAKE_CXX_COMPILER_ID STREQUAL GNU)
  foreach(copies memcpy memset)
    list(APPEND lanes_options "-m${copies}-strategy=vector_loop:8192:noalign,libcall:-1:noalign")
  endforeach()
endif()
# A loop's speed should not hang on where the one before it ends.
list(APPEND lanes_options -falign-functions=64)
# Else g++ makes a second loop of own steps for a whole group, no faster than that for any lanes, in a fifth of the time
# that all takes to compile.
if(CMAKE_CXX_COMPILER_ID STREQUAL GNU)
  list(APPEND lanes_options -fno-ipa-cp-clone)
endif()
set(lanes_scenes_each 6)

set(lanes_files "")
set(lanes_declared "")
set(lanes_entries "")
foreach(set IN LISTS lanes_sets ITEMS Beginning)
  set(lanes_text_${set} "")
endforeach()

# Writes what is gathered, as the nth file of each set.
macro(write_lanes nth)
  foreach(set IN LISTS lanes_sets ITEMS Beginning)
    set(header kernels)
    if(set STREQUAL Beginning)
      set(header beginning)
    endif()
    set(file ${lanes}/${set}_${nth}.cpp)
    file(CONFIGURE OUTPUT ${file} CONTENT "${lanes_included}#include \"report/lanes/${header}.hpp\"\n\n${lanes_text_${set}}" @ONLY)
    # Optimized in any build: what is not inlined would have the names of what is compiled for every machine.
    # Without sanitizers, with which they take longer to compile than all else: the suite has no lanes.
    set_source_files_properties(${file} PROPERTIES
      COMPILE_OPTIONS "${lanes_options};${lanes_flags_${set}};$<$<NOT:$<CONFIG:Release>>:${lanes_level};-fno-sanitize=all>")
    list(APPEND lanes_files ${file})
    set(lanes_text_${set} "")
  endforeach()
  set(lanes_included "")
endmacro()

file(GLOB lanes_headers RELATIVE ${PROJECT_SOURCE_DIR} CONFIGURE_DEPENDS chapters/*/*/models.hpp)
set(lanes_included "")
set(lanes_count 0)
set(lanes_part 0)
foreach(header IN LISTS lanes_headers)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/${header})
  file(STRINGS ${header} given REGEX "^struct Given")
  file(STRINGS ${header} namespace REGEX "^namespace oddity::")
  string(REGEX REPLACE "^namespace ([a-z0-9_:]+).*" "\\1" namespace "${namespace}")
  if(NOT given OR NOT header MATCHES "chapters/0?([0-9]+)_[a-z0-9_]+/0?([0-9]+)_[a-z0-9_]+/models.hpp$")
    continue()
  endif()
  set(number ${CMAKE_MATCH_1}_${CMAKE_MATCH_2})
  set(given ${namespace}::Given)
  string(APPEND lanes_included "#include \"${header}\"\n")
  set(compiled "")
  set(declared_here "")
  foreach(set IN LISTS lanes_sets)
    set(declared "extern const oddity::lanes::Compiled* const lanes_${number}_${set};\n")
    string(APPEND declared_here "${declared}")
    string(APPEND lanes_text_${set} "${declared}const oddity::lanes::Compiled* const lanes_${number}_${set} =\n"
      "    oddity::lanes::compiled_models<oddity::lanes::${set}, ${given}>.data();\n")
    string(APPEND compiled "lanes_${number}_${set}, ")
  endforeach()
  set(scene "oddity::lanes::SceneInLanes lanes_${number}();")
  string(APPEND lanes_declared "${scene}\n")
  string(APPEND lanes_text_Beginning "${declared_here}${scene}\noddity::lanes::SceneInLanes lanes_${number}() {\n"
    "  using namespace oddity::lanes;\n"
    "  return {\"${CMAKE_MATCH_1}.${CMAKE_MATCH_2}\", parameter_count<${given}>, model_count<${given}>,\n"
    "          beginnings<${given}>.data(), {${compiled}}};\n}\n")
  string(APPEND lanes_entries "      lanes_${number}(),\n")
  math(EXPR lanes_count "${lanes_count} + 1")
  math(EXPR full "${lanes_count} % ${lanes_scenes_each}")
  if(full EQUAL 0)
    write_lanes(${lanes_part})
    math(EXPR lanes_part "${lanes_part} + 1")
  endif()
endforeach()
if(lanes_included)
  write_lanes(${lanes_part})
endif()

# Operations alone, for what a register of each set can do at most.
set(lanes_repeated "")
foreach(set IN LISTS lanes_sets)
  set(declared "extern const oddity::lanes::Repeated* const lanes_repeated_${set};\n")
  string(APPEND lanes_declared "${declared}")
  string(APPEND lanes_repeated "lanes_repeated_${set}, ")
  string(CONCAT lanes_text_${set} "${declared}const oddity::lanes::Repeated* const lanes_repeated_${set} =\n"
    "    oddity::lanes::repeated<oddity::lanes::${set}>;\n")
  set(file ${lanes}/${set}_repeated.cpp)
  file(CONFIGURE OUTPUT ${file} CONTENT "#include \"report/lanes/repeated.hpp\"\n\n${lanes_text_${set}}" @ONLY)
  set_source_files_properties(${file} PROPERTIES
    COMPILE_OPTIONS "${lanes_flags_${set}};$<$<NOT:$<CONFIG:Release>>:-O2;-fno-sanitize=all>")
  list(APPEND lanes_files ${file})
endforeach()

file(CONFIGURE OUTPUT ${lanes}/register.cpp CONTENT [[
#include "report/lanes/scenes.hpp"

@lanes_declared@
const oddity::lanes::Library* oddity_lanes() {
  static const oddity::lanes::SceneInLanes scenes[] = {
@lanes_entries@  };
  static const oddity::lanes::Library all = {scenes, {@lanes_repeated@}};
  return &all;
}
]] @ONLY)

# Few runs have bodies in lanes, which take a fifth of the time that all else takes to compile: they are a library
# beside the program that is loaded where lanes are asked for.
add_library(oddity_lanes MODULE ${lanes_files} ${lanes}/register.cpp)
target_link_libraries(oddity_lanes PRIVATE oddity_options)
set_target_properties(oddity_lanes PROPERTIES CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON)
install(TARGETS oddity_lanes LIBRARY DESTINATION ${oddity_code} OPTIONAL)  # where it is built
