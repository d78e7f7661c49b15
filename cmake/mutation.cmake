# Of a mutated tree: the files of these chapters (a|b), which oddity_mutate links before those of another build.
if(ODDITY_MUTATED)
  set(mutated_files ${chapter_files} ${claim_files} ${exercise_files})
  list(FILTER mutated_files INCLUDE REGEX "^(${ODDITY_MUTATED})/")
  add_library(mutated OBJECT ${mutated_files})
  target_link_libraries(mutated PRIVATE oddity_solvers oddity_reference)
  compile_headers_once(mutated <Eigen/Core> chapters/scene.hpp)
  compile_files_together(mutated GROUP)
  file(GENERATE OUTPUT ${PROJECT_BINARY_DIR}/mutated.objects CONTENT "$<JOIN:$<FILTER:$<TARGET_OBJECTS:mutated>,EXCLUDE,[.]gch$>,\n>\n")
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
