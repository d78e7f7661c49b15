# The tables of true values and the code that generates them: oddity_reference, and the program
# make_reference.

file(GLOB route_files CONFIGURE_DEPENDS reference/make/[a-z]*.cpp)
list(REMOVE_ITEM route_files ${PROJECT_SOURCE_DIR}/reference/make/main.cpp)
set(table_files
  reference/csv.cpp reference/errors.cpp reference/files.cpp reference/interrupted.cpp reference/ledger.cpp reference/limits.cpp reference/made_again.cpp
  reference/proofs.cpp
  reference/quantity_text.cpp reference/reference.cpp
  reference/similar.cpp reference/table_text.cpp reference/truth.cpp reference/verdicts.cpp)
# Cached motions are computed again if a generator changes, or the code that runs it.
file(GLOB generator_sources CONFIGURE_DEPENDS
  reference/*.cpp reference/*.hpp reference/make/*.cpp reference/make/*.hpp)
set(rooms_of_reference ${PROJECT_SOURCE_DIR}/reference)
foreach(home IN LISTS own_homes)
  string(APPEND rooms_of_reference ",${home}/reference")
endforeach()
add_custom_command(OUTPUT ${PROJECT_BINARY_DIR}/fingerprint.cpp
  COMMAND ${CMAKE_COMMAND} -DFOLDERS=${rooms_of_reference} -DOUT=${PROJECT_BINARY_DIR}/fingerprint.cpp
    -P ${PROJECT_SOURCE_DIR}/reference/fingerprint.cmake
  DEPENDS ${generator_sources} ${own_generators} reference/fingerprint.cmake VERBATIM)
add_library(oddity_reference STATIC ${promised} ${table_files} ${route_files} ${truth_files} ${own_generators}
  ${PROJECT_BINARY_DIR}/truths.cpp ${PROJECT_BINARY_DIR}/fingerprint.cpp)
target_link_libraries(oddity_reference PUBLIC oddity_options Boost::headers ${MPFR} ${GMP})
target_compile_options(oddity_reference PRIVATE ${modest})
compile_headers_once(oddity_reference reference/make/routes.hpp reference/make/taylor.hpp)
compile_files_together(oddity_reference GROUP)
group_by_name(generators 4 ${route_files} ${truth_files})

# The generators of motions, whose last input is the time, also in long double and in double, under other names. Excludes
# the growth of small differences, which needs more digits.
set(motion_files "")
foreach(file IN LISTS truth_files own_truths)
  file(READ ${file} text)
  if(text MATCHES "\"t\"[ \n]*}|foucault::inputs" AND NOT file MATCHES "growth")
    list(APPEND motion_files ${file})
  endif()
endforeach()
register_truths(${PROJECT_BINARY_DIR}/motions.cpp ${motion_files})
set(shared_by_generators ${own_generators})
if(own_truths)
  list(REMOVE_ITEM shared_by_generators ${own_truths})
endif()
foreach(number IN ITEMS long_double double)
  string(REPLACE "_" " " type ${number})
  add_library(oddity_in_${number} OBJECT ${motion_files} ${shared_by_generators} ${route_files} reference/truth.cpp
    reference/in_long_double.cpp ${PROJECT_BINARY_DIR}/motions.cpp)
  target_compile_definitions(oddity_in_${number} PRIVATE
    "ODDITY_NUMBER=${type}" truth=truth_in_${number} motion_in_number=motion_in_${number})
  target_link_libraries(oddity_in_${number} PRIVATE oddity_options Boost::headers)
  compile_headers_once(oddity_in_${number} reference/make/routes.hpp reference/make/taylor.hpp)
  compile_files_together(oddity_in_${number} GROUP)
  target_sources(oddity_reference PRIVATE $<TARGET_OBJECTS:oddity_in_${number}>)
endforeach()

add_executable(make_reference reference/make/main.cpp)
target_link_libraries(make_reference PRIVATE oddity_reference)
target_compile_options(make_reference PRIVATE ${modest})
include(cmake/enclosures.cmake)
