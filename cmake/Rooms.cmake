# One target per room. A room sees its own headers and those of the rooms it links to, nothing else:
# an include of a higher room does not compile.
#
#   darwinop_room(NAME PATH [SEPARATE] [COMPUTES] [USES room ...])
#
# SEPARATE: its files repeat each other's names and cannot be compiled together.
#
# COMPUTES: mostly arithmetic, hours of simulated time. Optimised in debug builds, too, or tests would take ten times as
# long; DARWINOP_COMPUTE_OPTIONS says how.
#
# The headers of PATH are offered as "PATH/header.hpp" through a folder that holds links to them and to
# nothing else; the folder is what the target's users get as include path.

add_library(darwinop_options INTERFACE)
target_compile_features(darwinop_options INTERFACE cxx_std_20)
target_compile_options(darwinop_options INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wnon-virtual-dtor -Woverloaded-virtual -Werror
  # g++ leaves it out of -Wconversion for C++; both compilers shall say the same.
  $<$<CXX_COMPILER_ID:Clang>:-Wno-sign-conversion>)

set(DARWINOP_COMPUTE_OPTIONS "-O2;-g1" CACHE STRING "compiler options of rooms that compute, in debug builds")

function(darwinop_room NAME PATH)
  cmake_parse_arguments(ROOM "SEPARATE;COMPUTES" "" "USES" ${ARGN})
  file(GLOB headers CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/${PATH}/*.hpp")
  file(GLOB sources CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/${PATH}/*.cpp")

  set(shelf "${PROJECT_BINARY_DIR}/rooms/${NAME}")
  file(REMOVE_RECURSE "${shelf}")
  file(MAKE_DIRECTORY "${shelf}/${PATH}")
  foreach(header IN LISTS headers)
    get_filename_component(name "${header}" NAME)
    file(CREATE_LINK "${header}" "${shelf}/${PATH}/${name}" SYMBOLIC)
  endforeach()

  if(sources)
    add_library(${NAME} STATIC ${sources})
    set(scope PUBLIC)
    set_property(GLOBAL APPEND PROPERTY DARWINOP_ROOMS ${NAME})
    target_link_libraries(${NAME} PRIVATE darwinop_options)
    if(ROOM_COMPUTES)
      target_compile_options(${NAME} PRIVATE "$<$<CONFIG:Debug>:${DARWINOP_COMPUTE_OPTIONS}>")
    endif()
    if(ROOM_SEPARATE)
      set_target_properties(${NAME} PROPERTIES UNITY_BUILD OFF)
    endif()
  else()
    add_library(${NAME} INTERFACE)
    set(scope INTERFACE)
  endif()
  target_include_directories(${NAME} ${scope} "${shelf}")
  target_compile_features(${NAME} ${scope} cxx_std_20)
  target_link_libraries(${NAME} ${scope} ${ROOM_USES})
endfunction()
