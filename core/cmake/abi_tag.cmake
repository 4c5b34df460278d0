# The ABI tag of this build: headers of plugin/abi, compiler ABI, and every flag that changes code or bits.
# Nobody bumps it; it changes when one of these changes.
set(SPHONIC_SPEED_FLAGS -O3 -march=native -fno-math-errno -fno-trapping-math -fopenmp-simd)

file(GLOB _abi_headers CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/core/include/sphonic/plugin/abi/*.hpp)
list(SORT _abi_headers)
set_property(DIRECTORY ${PROJECT_SOURCE_DIR} APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${_abi_headers})
set(_abi_text "")
foreach(_header IN LISTS _abi_headers)
  file(SHA256 ${_header} _digest)
  string(APPEND _abi_text ${_digest})
endforeach()

# What "native" means on this machine.
execute_process(
  COMMAND ${CMAKE_CXX_COMPILER} -march=native -Q --help=target
  OUTPUT_VARIABLE _target ERROR_QUIET)
string(REGEX MATCH "-march=[ \t]+([^ \t\r\n]+)" _match "${_target};${CMAKE_BUILD_TYPE}")
set(_march ${CMAKE_MATCH_1})
if(NOT _march)
  set(_march ${CMAKE_SYSTEM_PROCESSOR})
endif()

string(REGEX MATCH "^[0-9]+" _compiler_major ${CMAKE_CXX_COMPILER_VERSION})
string(SHA256 _digest "${_abi_text};${SPHONIC_SPEED_FLAGS};${CMAKE_CXX_FLAGS};${SPHONIC_SANITIZE};${_target};${CMAKE_BUILD_TYPE}")
string(SUBSTRING ${_digest} 0 12 _digest)
set(SPHONIC_ABI_TAG "${CMAKE_CXX_COMPILER_ID}${_compiler_major}-${_march}-double-${_digest}")
message(STATUS "sphonic: ABI tag ${SPHONIC_ABI_TAG}")
