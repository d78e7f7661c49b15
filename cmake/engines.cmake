# Other people's engines, each as a program of its own beside oddity, which needs none of them:
#   engines/engine_NAME of solvers/engines/NAME.cpp, where its library is found.
# `--target engines` builds all that were found. Nothing else depends on them.

set(engine_programs "")

# add_engine(NAME HEADER header [INCLUDE folders...] LIBRARIES names...)
function(add_engine name)
  cmake_parse_arguments(engine "" "HEADER" "INCLUDE;LIBRARIES" ${ARGN})
  find_path(ODDITY_ENGINE_${name}_INCLUDE ${engine_HEADER} PATH_SUFFIXES ${engine_INCLUDE})
  set(libraries "")
  foreach(library IN LISTS engine_LIBRARIES)
    find_library(ODDITY_ENGINE_${library} ${library})
    list(APPEND libraries ${ODDITY_ENGINE_${library}})
  endforeach()
  if(NOT ODDITY_ENGINE_${name}_INCLUDE OR "${libraries}" MATCHES "NOTFOUND")
    message(STATUS "engine ${name}: not found")
    return()
  endif()
  message(STATUS "engine ${name}: ${libraries}")
  add_executable(engine_${name} EXCLUDE_FROM_ALL
    ${PROJECT_SOURCE_DIR}/solvers/engines/runner.cpp ${PROJECT_SOURCE_DIR}/solvers/engines/${name}.cpp)
  set_target_properties(engine_${name} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/engines)
  target_include_directories(engine_${name} PRIVATE ${PROJECT_SOURCE_DIR})
  target_include_directories(engine_${name} SYSTEM PRIVATE ${ODDITY_ENGINE_${name}_INCLUDE})
  target_compile_options(engine_${name} PRIVATE -Wall -Wextra -ffp-contract=off)
  target_link_libraries(engine_${name} PRIVATE nlohmann_json::nlohmann_json ${libraries})
  set(engine_programs ${engine_programs} engine_${name} PARENT_SCOPE)
endfunction()

add_engine(ode HEADER ode/ode.h LIBRARIES ode)
add_engine(mujoco HEADER mujoco/mujoco.h LIBRARIES mujoco)
add_engine(simbody HEADER Simbody.h INCLUDE simbody LIBRARIES SimTKsimbody SimTKmath SimTKcommon)
add_engine(dart HEADER Eigen/Dense INCLUDE eigen3 LIBRARIES dart)  # its headers lie beside eigen3

add_custom_target(engines DEPENDS ${engine_programs})
