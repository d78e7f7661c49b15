# cmake -P: refuses a file of those that FILES lists without the function that its name promises to a register: an
# exercise.cpp its exercise_N_M(), the maker of a table its truth_NAME(). Writes OUT. Else the linker would complain, and
# name no file.
file(READ "${FILES}" files)
foreach(file IN LISTS files)
  if(file MATCHES "/0?([0-9]+)_[^/]*/0?([0-9]+)_[^/]*/exercise[.]cpp$")
    set(promised "Exercise exercise_${CMAKE_MATCH_1}_${CMAKE_MATCH_2}()")
  else()
    cmake_path(GET file STEM name)
    set(promised "Truth truth_${name}()")
  endif()
  file(READ "${file}" text)
  string(FIND "${text}" "${promised} {" found)
  if(found EQUAL -1)
    message(FATAL_ERROR "${file}: it must define ${promised}, as its name promises")
  endif()
endforeach()
file(WRITE "${OUT}" "")
