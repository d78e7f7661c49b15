# Registers made from file names, so that a new file needs no other edit: exercises, generators of tables,
# algorithms, and the numbers of unknowns for which these are compiled.

# Writes the register of these exercises to `output`. Files of the tree have relative paths, others full
# paths.
function(register_exercises output)
  set(exercise_declarations "")
  set(exercise_entries "")
  set(numbered "")
  foreach(file IN LISTS ARGN)
    string(REGEX MATCH "[0-9][0-9]_[a-z0-9_]+/[0-9][0-9]_[a-z0-9_]+/exercise\\.cpp$" folder ${file})
    list(APPEND numbered "${folder}|${file}")
  endforeach()
  list(SORT numbered)
  set(before "")
  foreach(file IN LISTS numbered)
    string(REGEX REPLACE "^.*\\|" "" file ${file})
    if(NOT file MATCHES "chapters/([0-9][0-9])_[a-z0-9_]+/([0-9][0-9])_[a-z0-9_]+/exercise\\.cpp$")
      message(FATAL_ERROR "${file}: an exercise file is named chapters/NN_topic/MM_slug/exercise.cpp")
    endif()
    math(EXPR chapter "1${CMAKE_MATCH_1} - 100")
    math(EXPR index "1${CMAKE_MATCH_2} - 100")
    if("${chapter}.${index}" STREQUAL before)
      message(FATAL_ERROR "${file}: there is another exercise ${before}")
    endif()
    set(before ${chapter}.${index})
    string(APPEND exercise_declarations "Exercise exercise_${chapter}_${index}();  // ${file}\n")
    string(APPEND exercise_entries "      {{${chapter}, ${index}}, \"${file}\", exercise_${chapter}_${index}()},\n")
  endforeach()
  file(CONFIGURE OUTPUT ${output} CONTENT [[
#include "chapters/contents.hpp"

namespace oddity {

@exercise_declarations@
std::span<const Entry> registry() {
  static const Entry entries[] = {
@exercise_entries@  };
  return entries;
}

}  // namespace oddity
]] @ONLY)
endfunction()

# Writes the register of these generators of tables to `output`.
function(register_truths output)
  set(truth_declarations "")
  set(truth_entries "")
  foreach(file IN LISTS ARGN)
    if(NOT file MATCHES "reference/make/([0-9][0-9]_[0-9][0-9]_[a-z0-9_]+)\\.cpp$")
      message(FATAL_ERROR "${file}: the generator of a table is named reference/make/NN_MM_quantity.cpp")
    endif()
    string(APPEND truth_declarations "Truth truth_${CMAKE_MATCH_1}();  // ${file}\n")
    set(home "")
    if(IS_ABSOLUTE ${file})
      string(REGEX REPLACE "/reference/make/[^/]+$" "" home ${file})
    endif()
    string(REGEX MATCH "([0-9][0-9]_[0-9][0-9]_[a-z0-9_]+)\\.cpp$" file ${file})
    string(APPEND truth_entries "      {\"${CMAKE_MATCH_1}\", truth_${CMAKE_MATCH_1}, \"${home}\"},\n")
  endforeach()
  file(CONFIGURE OUTPUT ${output} CONTENT [[
#include "reference/truth.hpp"

namespace oddity::truth {

@truth_declarations@
const std::vector<Entry>& registry() {
  static const std::vector<Entry> entries{
@truth_entries@  };
  return entries;
}

}  // namespace oddity::truth
]] @ONLY)
endfunction()

# Writes files NAME_0.cpp, NAME_1.cpp ... in the folder, each of which compiles four of these entries
# F(Algorithm, header): reading Odeint's headers takes longer than compiling an algorithm. `output` lists the
# files, `output`_includes the headers.
function(write_algorithms output folder name)
  set(includes "")
  set(all "")
  set(algorithms "")
  set(files "")
  list(LENGTH ARGN left)
  foreach(entry IN LISTS ARGN)
    string(REGEX MATCH "[(]([A-Za-z0-9]+), ([a-z0-9_]+)[)]" entry "${entry}")
    string(APPEND includes "#include \"solvers/ode/${CMAKE_MATCH_2}.hpp\"\n")
    string(APPEND algorithms "ODDITY_PRECOMPILE(${CMAKE_MATCH_1})\n")
    math(EXPR left "${left} - 1")
    math(EXPR full "${left} % 4")
    if(full EQUAL 0)
      list(LENGTH files part)
      set(file ${folder}/${name}_${part}.cpp)
      file(CONFIGURE OUTPUT ${file} CONTENT [[
#include "solvers/ode/precompile.hpp"
@includes@
namespace oddity::ode {

@algorithms@
}  // namespace oddity::ode
]] @ONLY)
      list(APPEND files ${file})
      string(APPEND all "${includes}")
      set(includes "")
      set(algorithms "")
    endif()
  endforeach()
  set(${output} ${files} PARENT_SCOPE)
  set(${output}_includes "${all}" PARENT_SCOPE)
endfunction()

# Writes solvers/ode/all.hpp from solvers/ode/algorithms.hpp in the folder `generated`. `output` lists the
# files that compile the algorithms.
function(register_algorithms generated output)
  list_algorithms(entries ${PROJECT_SOURCE_DIR}/solvers/ode/algorithms.hpp)
  if(NOT SUNDIALS_FOUND)
    list(FILTER entries EXCLUDE REGEX ", (cvode|arkode)_")
  endif()
  write_algorithms(files ${generated} precompiled ${entries})
  file(CONFIGURE OUTPUT ${generated}/solvers/ode/all.hpp
    CONTENT "#pragma once\n\n#include \"solvers/ode/algorithms.hpp\"\n${files_includes}" @ONLY)
  set(${output} ${files} PARENT_SCOPE)
endfunction()

# Writes solvers/ode/unknowns.hpp in the folder `generated`: the numbers of unknowns for which the algorithms
# are compiled. These are the numbers of the solvers' tests and of problem files, and each size of a State
# declared in these folders of chapters.
function(register_unknowns generated)
  set(numbers 1 2 3 4 5 6 7 8 9 16 24)
  foreach(home IN LISTS ARGN)
    file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${home}/chapters/*.hpp ${home}/chapters/*.cpp)
    foreach(source IN LISTS sources)
      file(STRINGS ${source} states REGEX "using State = std::array<[A-Za-z]+, [0-9]+>;")
      if(states OR source MATCHES "/models[.]hpp$")
        set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${source})
      endif()
      foreach(state IN LISTS states)
        string(REGEX MATCH "([0-9]+)>" number "${state}")
        list(APPEND numbers ${CMAKE_MATCH_1})
      endforeach()
    endforeach()
  endforeach()
  list(SORT numbers COMPARE NATURAL)
  list(REMOVE_DUPLICATES numbers)
  list(TRANSFORM numbers REPLACE "(.+)" "F(\\1, __VA_ARGS__)")
  list(JOIN numbers " " calls)
  file(CONFIGURE OUTPUT ${generated}/solvers/ode/unknowns.hpp CONTENT [[
#pragma once

// F(n, arguments) for each number of unknowns n that the algorithms are compiled for.
#define ODDITY_FOR_UNKNOWNS(F, ...) @calls@
]] @ONLY)
endfunction()

# The texts of these files of these folders, as the function `name` of `header`. They depend on the other arguments.
function(embed name header folders files alone)
  string(REPLACE ";" "," folders "${folders}")
  string(REPLACE ";" "," files "${files}")
  add_custom_command(OUTPUT ${PROJECT_BINARY_DIR}/${name}.cpp
    COMMAND ${CMAKE_COMMAND} -DSOURCES=${folders} -DFILES=${files} -DNAME=${name} -DHEADER=${header} -DALONE=${alone}
      -DOUT=${PROJECT_BINARY_DIR}/${name}.cpp -P ${PROJECT_SOURCE_DIR}/cmake/embed.cmake
    DEPENDS ${ARGN} ${PROJECT_SOURCE_DIR}/cmake/embed.cmake VERBATIM)
endfunction()
