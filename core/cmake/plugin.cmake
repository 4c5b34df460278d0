# sphonic::plugin carries what a plugin needs: headers, language level, the flags its speed rests on, and the ABI tag.
add_library(sphonic_headers INTERFACE)
target_compile_features(sphonic_headers INTERFACE cxx_std_20)
target_include_directories(sphonic_headers INTERFACE
  $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/core/include> $<INSTALL_INTERFACE:include>)
set_target_properties(sphonic_headers PROPERTIES EXPORT_NAME headers)

add_library(sphonic_plugin INTERFACE)
add_library(sphonic::plugin ALIAS sphonic_plugin)
set_target_properties(sphonic_plugin PROPERTIES EXPORT_NAME plugin)
target_link_libraries(sphonic_plugin INTERFACE sphonic_headers)
target_compile_options(sphonic_plugin INTERFACE ${SPHONIC_SPEED_FLAGS})
target_compile_definitions(sphonic_plugin INTERFACE SPHONIC_ABI_TAG="${SPHONIC_ABI_TAG}")

include(${CMAKE_CURRENT_LIST_DIR}/sphonic_add_plugin.cmake)

install(TARGETS sphonic_headers sphonic_plugin EXPORT sphonic_targets)
install(EXPORT sphonic_targets FILE sphonic_targets.cmake NAMESPACE sphonic:: DESTINATION lib/cmake/sphonic)
install(FILES ${CMAKE_CURRENT_LIST_DIR}/sphonic-config.cmake ${CMAKE_CURRENT_LIST_DIR}/sphonic_add_plugin.cmake
  DESTINATION lib/cmake/sphonic)
install(DIRECTORY core/include/sphonic/plugin DESTINATION include/sphonic)
install(DIRECTORY cases/equations DESTINATION share/sphonic FILES_MATCHING PATTERN *.json)
install(DIRECTORY ${CMAKE_BINARY_DIR}/plugins/ DESTINATION lib/sphonic/plugins FILES_MATCHING PATTERN *.so)
