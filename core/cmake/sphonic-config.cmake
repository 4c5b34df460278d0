# find_package(sphonic): the target sphonic::plugin and the function sphonic_add_plugin(KIND FILE).
include(${CMAKE_CURRENT_LIST_DIR}/sphonic_targets.cmake)
include(${CMAKE_CURRENT_LIST_DIR}/sphonic_add_plugin.cmake)
