# Two WebAssembly modules for the page, made by the target models_module. models.js has the scenes' models,
# for the players; own.js reads and runs problem files. Both are assets of the site. They have Odeint's
# algorithms, as in the program.
set(ODDITY_MODULE AUTO CACHE STRING "The scenes' models as WebAssembly, for the page: ON, OFF, or AUTO: where clang can")
set_property(CACHE ODDITY_MODULE PROPERTY STRINGS AUTO ON OFF)
if(NOT ODDITY_MODULE)
  return()
endif()

find_program(WASM_CXX NAMES clang++ clang++-14 clang++-16 clang++-18 clang++-19)
find_program(GZIP gzip)
find_program(BASE64 base64)
set(module ${PROJECT_BINARY_DIR}/module)
set(wasm_flags --target=wasm32-wasi -ffp-contract=off -fno-rtti -fvisibility=hidden -mmutable-globals
  -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Wno-missing-braces -Wno-implicit-float-conversion)
if(WASM_CXX AND GZIP AND BASE64)
  # Tests the linker, the standard library and the runtime.
  file(CONFIGURE OUTPUT ${module}/tried.cpp CONTENT "#include <string>\nstd::string tried() { return {}; }\n")
  execute_process(COMMAND ${WASM_CXX} ${wasm_flags} -std=c++20 -mexec-model=reactor tried.cpp -o tried.wasm
    WORKING_DIRECTORY ${module} RESULT_VARIABLE wasm_fails OUTPUT_QUIET ERROR_QUIET)
else()
  set(wasm_fails TRUE)
endif()
if(wasm_fails)
  if(NOT ODDITY_MODULE STREQUAL AUTO)
    message(FATAL_ERROR "ODDITY_MODULE: there is no clang++ that compiles for wasm32-wasi with its standard library")
  endif()
  message(STATUS "The page's players do without the models' module: it needs clang, lld and the standard library for wasm32-wasi")
  return()
endif()
message(STATUS "The scenes' models are compiled for the page by ${WASM_CXX}")

# Include folder: Boost's headers without the machine's others,
file(MAKE_DIRECTORY ${module}/include)
get_target_property(boost Boost::headers INTERFACE_INCLUDE_DIRECTORIES)
file(CREATE_LINK ${boost}/boost ${module}/include/boost SYMBOLIC)
# the numbers of unknowns,
file(COPY ${PROJECT_BINARY_DIR}/generated/solvers/ode/unknowns.hpp DESTINATION ${module}/include/solvers/ode)
# and a register of Odeint's algorithms and ours, by their facts.
list_algorithms(entries ${PROJECT_SOURCE_DIR}/solvers/ode/algorithms.hpp)
set(calls "")
set(algorithms "")
foreach(entry IN LISTS entries)
  string(REGEX MATCH "[(]([A-Za-z0-9]+), ([a-z0-9_]+)[)]" matched "${entry}")
  set(header solvers/ode/${CMAKE_MATCH_2}.hpp)
  file(STRINGS ${header} found REGEX "library = (Facts::(odeint|own)|\"our own\")")
  file(STRINGS ${header} left_out REGEX "in_page = false")
  if(found AND NOT left_out)
    string(REGEX REPLACE "F[(](.*), .*" "\\1" algorithm "${entry}")
    string(APPEND calls "  f.template operator()<${algorithm}>();\n")
    list(APPEND algorithms "${entry}")
  endif()
endforeach()
write_algorithms(algorithm_files ${module} algorithms ${algorithms})
set(includes "${algorithm_files_includes}")
file(CONFIGURE OUTPUT ${module}/include/solvers/ode/all.hpp CONTENT [[
#pragma once

@includes@
namespace oddity::ode {

template <class F>
void for_each_algorithm(const F& f) {
@calls@}

}  // namespace oddity::ode
]] @ONLY)

# Folders of exercises outside the tree.
set(module_includes -I${PROJECT_SOURCE_DIR})
foreach(home IN LISTS own_homes)
  list(APPEND module_includes -I${home})
endforeach()
set(module_objects "")
# Compiles a source with these flags to an object, and adds it to the list `objects`.
function(compile_to objects object source)
  add_custom_command(OUTPUT ${object}
    COMMAND ${WASM_CXX} ${wasm_flags} ${ARGN} ${module_includes}
      -isystem ${module}/include -MD -MF ${object}.d -c ${source} -o ${object}
    DEPENDS ${source} DEPFILE ${object}.d VERBATIM)
  set(${objects} ${${objects}} ${object} PARENT_SCOPE)
endfunction()
# The scenes' models catch no exceptions.
function(compile_for_module source level standard)
  cmake_path(GET source STEM name)
  compile_to(module_objects ${module}/${name}.o ${source} -fignore-exceptions ${level} -std=${standard})
  set(module_objects ${module_objects} PARENT_SCOPE)
endfunction()

foreach(file events in_float integrate precompiled raw_problem)
  compile_for_module(${PROJECT_SOURCE_DIR}/solvers/ode/${file}.cpp -Os c++20)
endforeach()
compile_for_module(${PROJECT_SOURCE_DIR}/solvers/ode/implicit.cpp -Os c++17)  # as in the program
foreach(file IN LISTS algorithm_files)
  compile_for_module(${file} -Os c++20)
endforeach()
foreach(file at_time exports scene)
  compile_for_module(${PROJECT_SOURCE_DIR}/report/site/module/${file}.cpp -Os c++20)
endforeach()
set(shared_objects ${module_objects})  # code that steps any model
compile_for_module(${PROJECT_SOURCE_DIR}/report/site/module/no_catch.cpp -Os c++20)

# The models themselves, for speed, in a number of files that compile well in parallel.
add_executable(write_players report/site/module/write.cpp)
target_link_libraries(write_players PRIVATE oddity_report)
set(player_files "")
foreach(nth RANGE 5)
  list(APPEND player_files ${module}/players_${nth}.cpp)
endforeach()
add_custom_command(OUTPUT ${player_files} COMMAND write_players ${player_files} DEPENDS write_players VERBATIM)
foreach(file IN LISTS player_files)
  compile_for_module(${file} -O3 c++20)
endforeach()

# Links these objects and options to `name`.js. The stack comes first in memory, so that an overflow traps.
function(link_module name)
  set(objects ${ARGN})
  list(FILTER objects INCLUDE REGEX "[.]o$")
  add_custom_command(OUTPUT ${PROJECT_BINARY_DIR}/${name}.js
    COMMAND ${WASM_CXX} ${wasm_flags} -mexec-model=reactor -Wl,--gc-sections -Wl,--strip-all -Wl,--stack-first
      -Wl,-z,stack-size=1048576 -Wl,--export=malloc -Wl,--export=free -Wl,--export=__stack_pointer
      ${ARGN} -o ${module}/${name}.wasm
    COMMAND ${CMAKE_COMMAND} -DMODULE=${module}/${name}.wasm -DGZIP=${GZIP} -DBASE64=${BASE64}
      -DOUT=${PROJECT_BINARY_DIR}/${name}.js -P ${PROJECT_SOURCE_DIR}/cmake/pack.cmake
    DEPENDS ${objects} ${PROJECT_SOURCE_DIR}/cmake/pack.cmake VERBATIM)
endfunction()
link_module(models ${module_objects})

# ---- problem files, for the page in which users type them ---------------------------------------------------

# Errors in a file are thrown and caught, by the browsers' instructions for exceptions.
set(own ${PROJECT_SOURCE_DIR}/report/site/module/own)
set(own_flags -fwasm-exceptions -Os -std=c++20 -include ${own}/lacking.hpp)
file(CREATE_LINK ${TOML}/toml++ ${module}/include/toml++ SYMBOLIC)
set(own_objects ${shared_objects})
file(MAKE_DIRECTORY ${module}/own)
foreach(file
    chapters/claims chapters/compare_typeset chapters/formulas chapters/near_misses chapters/typeset chapters/verdict
    formula/differentiate formula/evaluate formula/gauss formula/letters formula/mutants formula/name_writer formula/parse
    formula/print_plain formula/print_tex formula/print_unicode formula/shown formula/signs formula/tokens formula/tree
    formula/unreadable formula/writer problem/abbreviations problem/claims problem/code problem/expression problem/file problem/formula
    problem/keys problem/measure problem/model problem/shape problem/staging problem/table reference/quantity_text reference/similar report/site/module/own/own
    report/site/module/own/played report/site/module/own/thrown report/text/readable)
  string(REPLACE "/" "_" name ${file})
  compile_to(own_objects ${module}/own/${name}.o ${PROJECT_SOURCE_DIR}/${file}.cpp ${own_flags})
endforeach()
link_module(own ${own_objects})

add_custom_target(own_module ALL DEPENDS ${PROJECT_BINARY_DIR}/own.js)
add_custom_target(models_module ALL DEPENDS ${PROJECT_BINARY_DIR}/models.js)
add_dependencies(models_module own_module)  # it shares that module's objects

# ---- the program's trials replayed by the module ----------------------------------------------------------

find_program(NODE NAMES node nodejs)
if(NOT ODDITY_TESTS OR NOT NODE)
  return()
endif()
set(functions sin cos tan asin acos exp expm1 log sinh cosh asinh atan2 hypot pow)
set(wraps "")
foreach(function IN LISTS functions)
  list(APPEND wraps -Wl,--wrap=${function} -Wl,--wrap=${function}f)
endforeach()
compile_for_module(${PROJECT_SOURCE_DIR}/tests/site/nudged.cpp -Os c++20)
list(REMOVE_ITEM module_objects ${module}/nudged.o)
link_module(models_nudged ${module_objects} ${module}/nudged.o ${wraps})
add_custom_target(models_nudged ALL DEPENDS ${PROJECT_BINARY_DIR}/models_nudged.js)
add_executable(write_trials tests/site/trials.cpp)
target_link_libraries(write_trials PRIVATE oddity_report)
set(trials ${module}/trials.json)
add_test(NAME trials_to_replay COMMAND write_trials ${PROJECT_SOURCE_DIR}/reference ${trials})
set_tests_properties(trials_to_replay PROPERTIES FIXTURES_SETUP trials_to_replay)
add_test(NAME replay COMMAND ${NODE} ${PROJECT_SOURCE_DIR}/tests/site/replay.mjs
  ${PROJECT_SOURCE_DIR}/report/site/assets/engine.js ${PROJECT_BINARY_DIR}/models.js
  ${PROJECT_BINARY_DIR}/models_nudged.js ${trials})
set_tests_properties(replay PROPERTIES FIXTURES_REQUIRED trials_to_replay)
