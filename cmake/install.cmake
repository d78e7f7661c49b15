# Installs the program with its tables, manual page and completion, and the models' headers as the target
# oddity::models of find_package(oddity).
include(CMakePackageConfigHelpers)

# Mode of created folders, whatever the umask: the program runs nothing that others can write to.
set(CMAKE_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)

install(TARGETS oddity RUNTIME)
install(DIRECTORY reference/ DESTINATION ${oddity_data}/reference
  FILES_MATCHING PATTERN "*.csv" PATTERN make EXCLUDE)
install(FILES ${PROJECT_BINARY_DIR}/models.js ${PROJECT_BINARY_DIR}/own.js DESTINATION ${oddity_data} OPTIONAL)

# ---- the models and loops, and the headers that they include ------------------------------------------------

# Installs these headers of the tree and all headers that they include.
function(install_headers)
  set(all "")
  while(ARGN)
    list(POP_FRONT ARGN header)
    if(NOT header IN_LIST all)
      list(APPEND all ${header})
      set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/${header})
      file(STRINGS ${PROJECT_SOURCE_DIR}/${header} includes REGEX "^#include \"")
      list(TRANSFORM includes REPLACE "^#include \"(.*)\".*" "\\1")
      list(APPEND ARGN ${includes})
      cmake_path(GET header PARENT_PATH folder)
      install(FILES ${PROJECT_SOURCE_DIR}/${header} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/oddity/${folder})
    endif()
  endwhile()
endfunction()
file(GLOB headers RELATIVE ${PROJECT_SOURCE_DIR} CONFIGURE_DEPENDS chapters/*/*/models.hpp report/plain/*.hpp)
install_headers(${headers})

add_library(oddity_models INTERFACE)
add_library(oddity::models ALIAS oddity_models)
set_target_properties(oddity_models PROPERTIES EXPORT_NAME models)
target_compile_features(oddity_models INTERFACE cxx_std_20)
target_include_directories(oddity_models INTERFACE
  $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/oddity>)

set(package ${CMAKE_INSTALL_DATADIR}/cmake/oddity)  # headers only: for any machine
install(TARGETS oddity_models EXPORT oddity)
install(EXPORT oddity NAMESPACE oddity:: DESTINATION ${package} FILE oddityConfig.cmake)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/oddityConfigVersion.cmake
  COMPATIBILITY SameMinorVersion ARCH_INDEPENDENT)
install(FILES ${PROJECT_BINARY_DIR}/oddityConfigVersion.cmake DESTINATION ${package})

# ---- the manual page and the completion, which the program writes ------------------------------------------

foreach(text manual completion)
  install(CODE "execute_process(COMMAND \"$<TARGET_FILE:oddity>\" --${text}
    OUTPUT_FILE \"${PROJECT_BINARY_DIR}/${text}\" COMMAND_ERROR_IS_FATAL ANY)")
endforeach()
install(FILES ${PROJECT_BINARY_DIR}/manual DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 RENAME oddity.1)
install(FILES ${PROJECT_BINARY_DIR}/completion DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions
  RENAME oddity)

# ---- a package for Debian of the installed files: ./oddity package ----------------------------------------

if(NOT PROJECT_IS_TOP_LEVEL)
  return()
endif()
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_PACKAGE_CONTACT "the owner of oddity <root@localhost>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "solutions of Game Physics, 2nd edition, checked by machine")
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "coq, libcoq-interval, libcoq-coquelicot")  # check the output of `oddity prove`
set(CPACK_DEBIAN_PACKAGE_SECTION math)
include(CPack)
