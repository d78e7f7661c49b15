# The library oddity_report, which shows results, and its embedded texts.

file(GLOB report_files CONFIGURE_DEPENDS report/*/*.cpp)
list(REMOVE_ITEM report_files ${PROJECT_SOURCE_DIR}/report/cli/main.cpp)
list(FILTER report_files EXCLUDE REGEX "/report/(verify|recorded)/")
# The headers that `choose --code` prints.
file(GLOB printed_headers RELATIVE ${PROJECT_SOURCE_DIR} CONFIGURE_DEPENDS
  chapters/*/*/*models.hpp report/plain/*.hpp)
set(printed_sources ${PROJECT_SOURCE_DIR})
foreach(home IN LISTS own_homes)
  list(APPEND printed_sources ${home})
  file(GLOB own_headers RELATIVE ${home} CONFIGURE_DEPENDS ${home}/chapters/*/*/*models.hpp)
  list(APPEND printed_headers ${own_headers})
endforeach()
file(GLOB headers_beside CONFIGURE_DEPENDS chapters/*.hpp chapters/*/*/*.hpp solvers/*.hpp
  solvers/ode/velocities.hpp report/plain/*.hpp)
# The files that `new` writes.
set(new_home ${PROJECT_SOURCE_DIR}/report/new)
file(GLOB_RECURSE new_paths CONFIGURE_DEPENDS report/new/*.cpp report/new/*.hpp)
file(GLOB_RECURSE new_files RELATIVE ${new_home} report/new/*.cpp report/new/*.hpp)
embed(embedded_headers report/study/embedded.hpp "${printed_sources}" "${printed_headers}" OFF ${headers_beside})
embed(embedded_templates report/cli/new_exercise.hpp ${new_home} "${new_files}" ON ${new_paths})
# The scenes that are problems' files, too.
file(GLOB scene_paths CONFIGURE_DEPENDS chapters/*/*/scene.toml)
file(GLOB scene_files RELATIVE ${PROJECT_SOURCE_DIR} CONFIGURE_DEPENDS chapters/*/*/scene.toml)
embed(embedded_scenes report/cli/new_exercise.hpp ${PROJECT_SOURCE_DIR} "${scene_files}" ON ${scene_paths})
file(GLOB asset_paths CONFIGURE_DEPENDS report/site/assets/*)
file(GLOB asset_files RELATIVE ${PROJECT_SOURCE_DIR}/report/site/assets CONFIGURE_DEPENDS report/site/assets/*)
embed(embedded_assets report/site/site.hpp ${PROJECT_SOURCE_DIR}/report/site/assets "${asset_files}" ON ${asset_paths})
file(GLOB problem_paths CONFIGURE_DEPENDS chapters/examples/problems/*.toml)
file(GLOB problem_texts RELATIVE ${PROJECT_SOURCE_DIR}/chapters/examples/problems CONFIGURE_DEPENDS
  chapters/examples/problems/*.toml)
embed(embedded_problems report/site/site.hpp ${PROJECT_SOURCE_DIR}/chapters/examples/problems "${problem_texts}" ON
  ${problem_paths})
# The listings' models made of numbers that record, in so many files; none is compiled again where it stays as it is.
set(recorder_parts 6)
set(recorders ${PROJECT_BINARY_DIR}/recorders.cpp)
foreach(part RANGE 1 ${recorder_parts})
  list(APPEND recorders ${PROJECT_BINARY_DIR}/recorders_${part}.cpp)
endforeach()
add_executable(oddity_recorder report/recorded/write.cpp)
target_link_libraries(oddity_recorder PRIVATE oddity_chapters)
link_fast(oddity_recorder)
set(own_recorder ${PROJECT_BINARY_DIR}/recorders_own.cpp)  # alone: no other object depends on a folder that may go
add_custom_command(OUTPUT ${recorders} ${own_recorder}
  COMMAND oddity_recorder ${PROJECT_BINARY_DIR} ${recorder_parts} DEPENDS oddity_recorder VERBATIM)
if(own_homes)
  list(APPEND recorders ${own_recorder})
endif()
add_library(oddity_recorders OBJECT ${recorders})
target_link_libraries(oddity_recorders PRIVATE oddity_chapters)
target_include_directories(oddity_recorders PRIVATE ${own_homes})
target_compile_options(oddity_recorders PRIVATE ${least})
set_target_properties(oddity_recorders PROPERTIES EXPORT_COMPILE_COMMANDS OFF)
add_library(oddity_report STATIC ${report_files} $<TARGET_OBJECTS:oddity_recorders> ${PROJECT_BINARY_DIR}/embedded_headers.cpp
  ${PROJECT_BINARY_DIR}/embedded_templates.cpp ${PROJECT_BINARY_DIR}/embedded_scenes.cpp
  ${PROJECT_BINARY_DIR}/embedded_assets.cpp ${PROJECT_BINARY_DIR}/embedded_problems.cpp)
target_link_libraries(oddity_report PUBLIC oddity_problem oddity_chapters CLI11::CLI11 nlohmann_json::nlohmann_json TBB::tbb
  ${CMAKE_DL_LIBS})
target_compile_options(oddity_report PRIVATE ${least})
set_source_files_properties(report/cli/enclosing.cpp PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
if(TARGET oddity_enclosures)
  target_link_libraries(oddity_report PRIVATE oddity_enclosures)
  set_source_files_properties(report/cli/enclosing.cpp PROPERTIES COMPILE_DEFINITIONS ODDITY_ARB)
endif()
compile_headers_once(oddity_report report/study/run.hpp)
compile_files_together(oddity_report GROUP)
foreach(room_and_groups charts-2 cli-2 pages-2 site-2 study-4 text-1)  # about nine files a group
  string(REGEX MATCH "(.*)-(.*)" room ${room_and_groups})
  file(GLOB files report/${CMAKE_MATCH_1}/*.cpp)
  group_by_name(${CMAKE_MATCH_1} ${CMAKE_MATCH_2} ${files})
endforeach()
set_source_files_properties(report/cli/commands.cpp report/study/json.cpp PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
set_property(SOURCE report/study/settings.cpp APPEND PROPERTY COMPILE_DEFINITIONS
  ODDITY_VERSION="${PROJECT_VERSION}")
set_property(SOURCE report/study/sibling_program.cpp APPEND PROPERTY COMPILE_DEFINITIONS
  ODDITY_SOURCE="${PROJECT_SOURCE_DIR}" ODDITY_BUILD="${build_by_name}"
  ODDITY_INSTALLED_DATA="${oddity_data}" ODDITY_INSTALLED_CODE="${oddity_code}")
