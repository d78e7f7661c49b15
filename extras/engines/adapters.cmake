# Third-party engines, each a separate program. oddity itself needs none of them:
#   engines/engine_NAME of adapters/NAME.cpp, where its library is found; its settings are in variants.json.
#   If there are several SOURCES, the first is the adapter.
# `--target engines` builds all that were found. Nothing else depends on them.

set(engine_programs "")

# add_engine(NAME [SOURCES names...] HEADER header [INCLUDE folders...] [DEFINES names...] LIBRARIES names...)
function(add_engine name)
  cmake_parse_arguments(engine "" "HEADER" "SOURCES;INCLUDE;DEFINES;LIBRARIES" ${ARGN})
  if(NOT engine_SOURCES)
    set(engine_SOURCES ${name})
  endif()
  list(GET engine_SOURCES 0 adapter)
  list(TRANSFORM engine_SOURCES PREPEND ${CMAKE_CURRENT_SOURCE_DIR}/adapters/)
  list(TRANSFORM engine_SOURCES APPEND .cpp)
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
    ${CMAKE_CURRENT_SOURCE_DIR}/adapters/runner.cpp ${engine_SOURCES})
  set_target_properties(engine_${name} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/engines)
  target_include_directories(engine_${name} PRIVATE ${PROJECT_SOURCE_DIR})
  target_include_directories(engine_${name} SYSTEM PRIVATE ${ODDITY_ENGINE_${name}_INCLUDE})
  list(GET libraries 0 first)
  file(REAL_PATH ${first} first)
  string(REGEX MATCH "[0-9][0-9.]*$" of_file ${first})
  target_compile_definitions(engine_${name} PRIVATE VERSION_OF_FILE="${of_file}" ADAPTER="${adapter}.cpp"
    ${engine_DEFINES})
  target_compile_options(engine_${name} PRIVATE -Wall -Wextra -ffp-contract=off)
  target_link_libraries(engine_${name} PRIVATE nlohmann_json::nlohmann_json ${libraries})
  set(engine_programs ${engine_programs} engine_${name} PARENT_SCOPE)
endfunction()

add_engine(box2d SOURCES box2d box2d_world HEADER box2d/box2d.h LIBRARIES box2d)
add_engine(bullet HEADER btBulletDynamicsCommon.h INCLUDE bullet LIBRARIES BulletDynamics BulletCollision LinearMath)
add_engine(bullet_double SOURCES bullet HEADER btBulletDynamicsCommon.h INCLUDE bullet
  DEFINES BT_USE_DOUBLE_PRECISION LIBRARIES BulletDynamics-float64 BulletCollision-float64 LinearMath-float64)
add_engine(bullet_multibody SOURCES bullet_multibody bullet_tree HEADER btBulletDynamicsCommon.h INCLUDE bullet LIBRARIES BulletDynamics BulletCollision LinearMath)
add_engine(bullet_multibody_double SOURCES bullet_multibody bullet_tree HEADER btBulletDynamicsCommon.h INCLUDE bullet
  DEFINES BT_USE_DOUBLE_PRECISION LIBRARIES BulletDynamics-float64 BulletCollision-float64 LinearMath-float64)
add_engine(chipmunk SOURCES chipmunk chipmunk_world HEADER chipmunk/chipmunk.h LIBRARIES chipmunk)
add_engine(ode SOURCES ode ode_world HEADER ode/ode.h LIBRARIES ode)
add_engine(mujoco SOURCES mujoco mujoco_model mujoco_xml HEADER mujoco/mujoco.h LIBRARIES mujoco)
add_engine(simbody SOURCES simbody simbody_world HEADER Simbody.h INCLUDE simbody LIBRARIES SimTKsimbody SimTKmath SimTKcommon)
add_engine(dart SOURCES dart dart_world HEADER Eigen/Dense INCLUDE eigen3 LIBRARIES dart)  # headers next to eigen3

configure_file(adapters/variants.json ${PROJECT_BINARY_DIR}/engines/variants.json COPYONLY)  # read by the programs
add_custom_target(engines DEPENDS ${engine_programs})
