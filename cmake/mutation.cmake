# Of a mutated tree: the libraries' files of these rooms (a|b), which oddity_mutate links before another build's, and
# the tests that it takes in place of that build's.
if(ODDITY_MUTATED)
  add_custom_target(mutated)
  # What comes of the target, if it is there, as TARGET.objects.
  function(list_objects target)
    set(objects "")
    if(TARGET ${target})
      add_dependencies(mutated ${target})
      set(objects "$<FILTER:$<TARGET_OBJECTS:${target}>,EXCLUDE,[.]gch$>")
    endif()
    file(GENERATE OUTPUT ${PROJECT_BINARY_DIR}/${target}.objects CONTENT "$<JOIN:${objects},\n>\n")
  endfunction()
  # Those of the files that are in the rooms, compiled as this library's.
  function(add_mutated name mode library header)
    list(FILTER ARGN INCLUDE REGEX "(^|/)(${ODDITY_MUTATED})/")
    if(ARGN)
      add_library(mutated_${name} OBJECT ${ARGN})
      target_link_libraries(mutated_${name} PRIVATE ${library})
      compile_headers_once(mutated_${name} ${header})
      compile_files_together(mutated_${name} ${mode})
    endif()
    list_objects(mutated_${name})
  endfunction()
  add_mutated(formula GROUP oddity_formula formula/evaluate.hpp ${formula_files})
  add_mutated(solvers GROUP oddity_solvers ${PROJECT_BINARY_DIR}/generated/solvers/ode/all.hpp ${solver_files})
  if("solvers" MATCHES "^(${ODDITY_MUTATED})$")
    target_sources(mutated_solvers PRIVATE ${precompiled_files})
    add_library(mutated_ublas OBJECT solvers/ode/implicit.cpp)
    set_target_properties(mutated_ublas PROPERTIES CXX_STANDARD 17)
    target_link_libraries(mutated_ublas PRIVATE oddity_options Boost::headers Eigen3::Eigen)
  endif()
  list_objects(mutated_ublas)
  add_mutated(makers BATCH oddity_reference reference/make/taylor.hpp ${route_files} ${truth_files})
  add_mutated(chapters GROUP oddity_chapters chapters/scene.hpp ${chapter_files} ${claim_files} ${exercise_files})
  add_mutated(report GROUP oddity_report report/study/run.hpp ${report_files})
  list_objects(mutated_tests)
endif()

# oddity_mutate, where libclang is found (libclang-dev): tests/mutation/.

find_path(ODDITY_LIBCLANG_INCLUDE clang-c/Index.h
  PATHS /usr/lib/llvm-19/include /usr/lib/llvm-18/include /usr/lib/llvm-16/include /usr/lib/llvm-14/include)
find_library(ODDITY_LIBCLANG NAMES clang libclang
  PATHS /usr/lib/llvm-19/lib /usr/lib/llvm-18/lib /usr/lib/llvm-16/lib /usr/lib/llvm-14/lib)
if(NOT ODDITY_LIBCLANG_INCLUDE OR NOT ODDITY_LIBCLANG)
  message(STATUS "libclang not found: no oddity_mutate")
  return()
endif()
message(STATUS "libclang: ${ODDITY_LIBCLANG}, for oddity_mutate")
file(GLOB mutation_files CONFIGURE_DEPENDS tests/mutation/*.cpp)
add_executable(oddity_mutate EXCLUDE_FROM_ALL ${mutation_files} report/study/parallel.cpp report/study/run_program.cpp
  reference/csv.cpp reference/files.cpp reference/interrupted.cpp reference/proofs.cpp)
target_include_directories(oddity_mutate SYSTEM PRIVATE ${ODDITY_LIBCLANG_INCLUDE})
target_compile_definitions(oddity_mutate PRIVATE
  ODDITY_SOURCE="${PROJECT_SOURCE_DIR}" ODDITY_BUILT="${PROJECT_BINARY_DIR}")
target_link_libraries(oddity_mutate PRIVATE oddity_options TBB::tbb Boost::headers CLI11::CLI11 nlohmann_json::nlohmann_json
  ${ODDITY_LIBCLANG})
