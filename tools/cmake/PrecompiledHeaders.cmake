# Precompiled headers of the rooms: the standard library, and for darwinop gap Eigen and JSON also, are read once for all
# rooms with the same compiler options. Half of the time that a room's batch takes is spent on reading them.
#
# Only with batches: preset debug compiles each file by itself, and shows where an include is missing.
set(DARWINOP_STANDARD_HEADERS <algorithm> <array> <atomic> <bitset> <charconv> <chrono> <cmath> <filesystem> <fstream>
  <functional> <iostream> <limits> <map> <memory> <mutex> <optional> <ranges> <set> <span> <sstream> <string> <thread>
  <variant> <vector>)
set(DARWINOP_EIGEN_HEADERS <Eigen/Cholesky> <Eigen/Eigenvalues> <Eigen/LU> <Eigen/QR>)

# g++ 12 takes "a" + std::string for a copy out of bounds (bug 105651), which it passes over in headers that are not
# precompiled. Debug builds and clang++ keep these warnings, sanitizers find what they are for.
set(DARWINOP_PRECOMPILED_OPTIONS)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
  set(DARWINOP_PRECOMPILED_OPTIONS -Wno-array-bounds -Wno-restrict -Wno-stringop-overflow
    -Wno-stringop-overread)
endif()

add_custom_target(precompiled_headers)  # all of them: clang-tidy also reads units that are not built

# To be called when nothing changes the options of the rooms any more.
function(darwinop_precompile_headers)
  if(NOT CMAKE_UNITY_BUILD)
    return()
  endif()
  set(groups)
  foreach(path IN LISTS DARWINOP_ROOM_PATHS)
    darwinop_room_name("${path}" room)
    if(NOT TARGET ${room})
      continue()
    endif()
    get_target_property(type ${room} TYPE)
    if(NOT type STREQUAL "STATIC_LIBRARY")
      continue()
    endif()
    set(headers)
    if(path MATCHES "^gap/")
      set(headers eigen json)
    elseif("light" IN_LIST DARWINOP_ROOM_${room}_BUILD)
      set(headers json)  # most of them
    endif()
    get_target_property(options ${room} COMPILE_OPTIONS)
    get_target_property(shareable ${room} POSITION_INDEPENDENT_CODE)
    string(MD5 group "${headers} ${options} ${shareable}")
    string(SUBSTRING "${group}" 0 8 group)
    list(APPEND groups ${group})
    list(APPEND rooms_${group} ${room})
    set(headers_${group} "${headers}")
    set(options_${group} "${options}")
    set(shareable_${group} "${shareable}")
  endforeach()
  list(REMOVE_DUPLICATES groups)
  foreach(group IN LISTS groups)
    list(LENGTH rooms_${group} count)
    if(count LESS 5)
      continue()  # takes as long as the headers of four rooms
    endif()
    set(owner room_headers_${group})
    add_library(${owner} OBJECT EXCLUDE_FROM_ALL "${PROJECT_SOURCE_DIR}/tools/cmake/room_headers.cpp")
    add_dependencies(precompiled_headers ${owner})
    target_link_libraries(${owner} PRIVATE darwinop_options)
    target_precompile_headers(${owner} PRIVATE ${DARWINOP_STANDARD_HEADERS})
    if("json" IN_LIST headers_${group})
      target_precompile_headers(${owner} PRIVATE <nlohmann/json.hpp>)
    endif()
    if("eigen" IN_LIST headers_${group})
      target_precompile_headers(${owner} PRIVATE ${DARWINOP_EIGEN_HEADERS})
    endif()
    foreach(library IN LISTS headers_${group})
      darwinop_library(${library} found)
      target_link_libraries(${owner} PRIVATE ${found})
    endforeach()
    if(options_${group})
      target_compile_options(${owner} PRIVATE ${options_${group}})
    endif()
    if(shareable_${group})
      set_target_properties(${owner} PROPERTIES POSITION_INDEPENDENT_CODE ON)
    endif()
    foreach(room IN LISTS rooms_${group})
      target_precompile_headers(${room} REUSE_FROM ${owner})
      target_compile_options(${room} PRIVATE ${DARWINOP_PRECOMPILED_OPTIONS})
    endforeach()
  endforeach()
endfunction()
