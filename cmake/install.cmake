# What `cmake --install` puts in place: the program with its tables, manual page and completion, and the models'
# headers as the target oddity::models of find_package(oddity).
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

install(TARGETS oddity RUNTIME)
install(DIRECTORY reference/ DESTINATION ${CMAKE_INSTALL_DATADIR}/oddity/reference
  FILES_MATCHING PATTERN "*.csv" PATTERN make EXCLUDE)
install(DIRECTORY tests/mutation tests/fuzz tests/faults DESTINATION ${CMAKE_INSTALL_DATADIR}/oddity/tests
  FILES_MATCHING PATTERN "mutation.csv" PATTERN "record.csv" PATTERN corpus EXCLUDE)
install(FILES ${PROJECT_BINARY_DIR}/models.js DESTINATION ${CMAKE_INSTALL_DATADIR}/oddity OPTIONAL)

# ---- the models, loops and lanes, and the headers that they include ---------------------------------------

file(GLOB headers RELATIVE ${PROJECT_SOURCE_DIR} CONFIGURE_DEPENDS chapters/*/*/models.hpp report/plain/*.hpp)
list(APPEND headers solvers/lanes/integrate.hpp)
set(model_headers "")
while(headers)
  list(POP_FRONT headers header)
  if(NOT header IN_LIST model_headers)
    list(APPEND model_headers ${header})
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${header})
    file(STRINGS ${header} includes REGEX "^#include \"")
    list(TRANSFORM includes REPLACE "^#include \"(.*)\".*" "\\1")
    list(APPEND headers ${includes})
  endif()
endwhile()
foreach(header IN LISTS model_headers)
  cmake_path(GET header PARENT_PATH folder)
  install(FILES ${header} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/oddity/${folder})
endforeach()

add_library(oddity_models INTERFACE)
add_library(oddity::models ALIAS oddity_models)
set_target_properties(oddity_models PROPERTIES EXPORT_NAME models)
target_compile_features(oddity_models INTERFACE cxx_std_20)
target_include_directories(oddity_models INTERFACE
  $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/oddity>)

set(package ${CMAKE_INSTALL_DATADIR}/cmake/oddity)  # headers alone: for any machine
install(TARGETS oddity_models EXPORT oddity)
install(EXPORT oddity NAMESPACE oddity:: DESTINATION ${package} FILE oddityConfig.cmake)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/oddityConfigVersion.cmake
  COMPATIBILITY SameMinorVersion ARCH_INDEPENDENT)
install(FILES ${PROJECT_BINARY_DIR}/oddityConfigVersion.cmake DESTINATION ${package})

# ---- the manual page, which is what the program says of itself, and the completion, which asks it ---------

install(CODE "execute_process(COMMAND \"${CMAKE_COMMAND}\" \"-DPROGRAM=$<TARGET_FILE:oddity>\"
  \"-DOUT=${PROJECT_BINARY_DIR}/oddity.1\" -P \"${PROJECT_SOURCE_DIR}/cmake/manual.cmake\" COMMAND_ERROR_IS_FATAL ANY)")
install(FILES ${PROJECT_BINARY_DIR}/oddity.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
install(FILES cmake/completion.bash DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions RENAME oddity)
