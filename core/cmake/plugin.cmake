# sphonic::plugin carries what a plugin needs: headers, language level, the flags its speed rests on, and the ABI tag.
add_library(sphonic_headers INTERFACE)
target_compile_features(sphonic_headers INTERFACE cxx_std_20)
target_include_directories(sphonic_headers INTERFACE ${PROJECT_SOURCE_DIR}/core/include)

add_library(sphonic_plugin INTERFACE)
add_library(sphonic::plugin ALIAS sphonic_plugin)
target_link_libraries(sphonic_plugin INTERFACE sphonic_headers)
target_compile_options(sphonic_plugin INTERFACE ${SPHONIC_SPEED_FLAGS})
target_compile_definitions(sphonic_plugin INTERFACE SPHONIC_ABI_TAG="${SPHONIC_ABI_TAG}")

# sphonic_add_plugin(KIND FILE): one file, one library KIND.NAME.so, where NAME is the file's name.
function(sphonic_add_plugin kind file)
  get_filename_component(name ${file} NAME_WE)
  set(target ${kind}.${name})
  add_library(${target} MODULE ${file})
  target_link_libraries(${target} PRIVATE sphonic::plugin)
  set_target_properties(${target} PROPERTIES
    PREFIX "" OUTPUT_NAME ${target} CXX_VISIBILITY_PRESET hidden
    LIBRARY_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/plugins)
  add_dependencies(sphonic_plugins ${target})
  install(TARGETS ${target} LIBRARY DESTINATION lib/sphonic/plugins)
endfunction()
