# What a controller builds against: one static library with every room that the API uses, the public headers, and the three ways
# to find them (find_package(darwinop), pkg-config darwinop, Makefile.include). Component "sdk" of the install.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

darwinop_rooms_below(rooms managers webots)  # on the robot without remote/client, so without libjpeg
foreach(room IN LISTS rooms)
  get_target_property(type ${room} TYPE)
  if(type STREQUAL "STATIC_LIBRARY")
    list(APPEND room_objects $<TARGET_OBJECTS:${room}>)
  endif()
endforeach()

# Where a controller's process looks for it: beside the running program, then where it was built, then where it is
# installed. The robot's programs get none: they cannot load a library, and report that.
if(NOT CMAKE_CROSSCOMPILING)
  set_source_files_properties(connect/twin_library.cpp PROPERTIES COMPILE_DEFINITIONS
    "DARWINOP_TWIN_FOLDERS=\"lib\",\"${CMAKE_INSTALL_LIBDIR}\",\"${CMAKE_BINARY_DIR}/lib\",\"${CMAKE_INSTALL_FULL_LIBDIR}\";DARWINOP_VERSION=\"${PROJECT_VERSION}\"")
endif()

# Where a controller's process looks for darwinop-sound after its own folder: where it was built and is installed.
if(CMAKE_CROSSCOMPILING)
  set(sound_folders "\"/opt/darwinop/current/sound\"")
else()
  set(sound_folders "\"${CMAKE_RUNTIME_OUTPUT_DIRECTORY}\",\"${CMAKE_INSTALL_FULL_BINDIR}\"")
endif()
set_source_files_properties(connect/sound_program.cpp PROPERTIES COMPILE_DEFINITIONS "DARWINOP_SOUND_FOLDERS=${sound_folders}")

# inih, libxcb and, on a PC, libjpeg go into the library, so that neither a controller's build nor the robot needs them.
set(darwinop_taken_in)     # their objects
set(darwinop_other_flags)  # those that have no archive here
function(darwinop_take_in NAME)
  find_library(DARWINOP_${NAME}_ARCHIVE lib${NAME}.a)
  if(NOT DARWINOP_${NAME}_ARCHIVE)
    set(darwinop_other_flags ${darwinop_other_flags} ${NAME} PARENT_SCOPE)
    return()
  endif()
  execute_process(COMMAND "${CMAKE_AR}" t "${DARWINOP_${NAME}_ARCHIVE}" OUTPUT_VARIABLE members
    OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
  string(REPLACE "\n" ";" members "${members}")
  set(unpacked "${PROJECT_BINARY_DIR}/${NAME}")
  file(MAKE_DIRECTORY "${unpacked}")
  list(TRANSFORM members PREPEND "${unpacked}/" OUTPUT_VARIABLE objects)
  add_custom_command(OUTPUT ${objects} DEPENDS "${DARWINOP_${NAME}_ARCHIVE}" WORKING_DIRECTORY "${unpacked}"
    COMMAND "${CMAKE_AR}" x "${DARWINOP_${NAME}_ARCHIVE}" COMMENT "Taking ${NAME} apart" VERBATIM)
  set_source_files_properties(${objects} PROPERTIES EXTERNAL_OBJECT TRUE GENERATED TRUE)
  set(darwinop_taken_in ${darwinop_taken_in} ${objects} PARENT_SCOPE)
endfunction()
set(taken_libraries inih xcb Xau)
if(NOT CMAKE_CROSSCOMPILING)
  list(APPEND taken_libraries jpeg)  # pictures over TCP
endif()
foreach(library IN LISTS taken_libraries)
  darwinop_take_in(${library})
endforeach()

# Not named darwinop: that is the command's target.
add_library(darwinop_sdk STATIC ${room_objects} ${darwinop_taken_in})
add_library(darwinop::darwinop ALIAS darwinop_sdk)
set_target_properties(darwinop_sdk PROPERTIES LINKER_LANGUAGE CXX OUTPUT_NAME darwinop EXPORT_NAME darwinop)
target_include_directories(darwinop_sdk INTERFACE
  "$<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/webots/include;${PROJECT_SOURCE_DIR}/managers/include>"
  "$<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/darwinop;${CMAKE_INSTALL_INCLUDEDIR}/darwinop/managers>")
target_compile_definitions(darwinop_sdk INTERFACE CROSSCOMPILATION LINUX)
target_link_libraries(darwinop_sdk INTERFACE Threads::Threads rt ${darwinop_other_flags})

install(TARGETS darwinop_sdk EXPORT darwinop ARCHIVE DESTINATION "${CMAKE_INSTALL_LIBDIR}" COMPONENT sdk)
install(DIRECTORY webots/include/webots DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/darwinop" COMPONENT sdk)
install(DIRECTORY managers/include/ DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/darwinop/managers" COMPONENT sdk)

set(package_dir "${CMAKE_INSTALL_LIBDIR}/cmake/darwinop")
install(EXPORT darwinop NAMESPACE darwinop:: FILE darwinopTargets.cmake DESTINATION "${package_dir}" COMPONENT sdk)
configure_package_config_file(tools/cmake/darwinopConfig.cmake.in darwinopConfig.cmake INSTALL_DESTINATION "${package_dir}")
write_basic_package_version_file(darwinopConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES "${PROJECT_BINARY_DIR}/darwinopConfig.cmake" "${PROJECT_BINARY_DIR}/darwinopConfigVersion.cmake"
  DESTINATION "${package_dir}" COMPONENT sdk)

# Both find the library beside themselves, so that an installed tree can be moved as a whole.
set(pc_dir "${CMAKE_INSTALL_LIBDIR}/pkgconfig")
file(RELATIVE_PATH DARWINOP_PC_PREFIX "/${pc_dir}" "/")
list(TRANSFORM darwinop_other_flags PREPEND " -l" OUTPUT_VARIABLE flags)
string(JOIN "" DARWINOP_OTHER_FLAGS ${flags})
configure_file(tools/cmake/darwinop.pc.in darwinop.pc @ONLY)
configure_file(tools/cmake/Makefile.include.in Makefile.include @ONLY)
install(FILES "${PROJECT_BINARY_DIR}/darwinop.pc" DESTINATION "${pc_dir}" COMPONENT sdk)
install(FILES "${PROJECT_BINARY_DIR}/Makefile.include" DESTINATION "${CMAKE_INSTALL_DATADIR}/darwinop" COMPONENT sdk)
install(PROGRAMS tools/cmake/make.sh RENAME make DESTINATION "${CMAKE_INSTALL_DATADIR}/darwinop/bin" COMPONENT sdk)
install(PROGRAMS tools/cmake/old-make.sh RENAME old-make DESTINATION "${CMAKE_INSTALL_DATADIR}/darwinop" COMPONENT sdk)

# Makefile.include reads it, and others who build for the robot without CMake.
if(CMAKE_CROSSCOMPILING)
  configure_file(tools/cmake/robot-toolchain.mk.in robot-toolchain.mk @ONLY)
  install(FILES "${PROJECT_BINARY_DIR}/robot-toolchain.mk" DESTINATION "${CMAKE_INSTALL_DATADIR}/darwinop" COMPONENT sdk)
endif()
