# sphonic_add_plugin(KIND FILE): one file, one library plugins/KIND.NAME.so, where NAME is the file's name.
function(sphonic_add_plugin kind file)
  get_filename_component(name ${file} NAME_WE)
  set(target ${kind}.${name})
  add_library(${target} MODULE ${file})
  target_link_libraries(${target} PRIVATE sphonic::plugin)
  set_target_properties(${target} PROPERTIES
    PREFIX "" OUTPUT_NAME ${target} CXX_VISIBILITY_PRESET hidden
    LIBRARY_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/plugins)
endfunction()
