# What goes to the robot: component "robot" of the install, laid out as it lies in /opt/darwinop/versions/<VERSION>.
# tools/make_bundle.sh makes an archive of it. Another program is one line: darwinop_robot_program(TARGET).

# The version of a bundle, also the name of its folder on the robot: 0.1.0+<commit>, and .dirty for what no commit has.
if(commit)
  string(REPLACE "-dirty" ".dirty" DARWINOP_BUNDLE_VERSION "${PROJECT_VERSION}+${commit}")
else()
  set(DARWINOP_BUNDLE_VERSION "${PROJECT_VERSION}")
endif()
file(WRITE "${PROJECT_BINARY_DIR}/VERSION" "${DARWINOP_BUNDLE_VERSION}\n")
install(FILES "${PROJECT_BINARY_DIR}/VERSION" DESTINATION . COMPONENT robot EXCLUDE_FROM_ALL)

# Which robots it is for; the installer compares it with `uname -m` there.
file(WRITE "${PROJECT_BINARY_DIR}/ARCHITECTURE" "${CMAKE_SYSTEM_PROCESSOR}\n")
install(FILES "${PROJECT_BINARY_DIR}/ARCHITECTURE" DESTINATION . COMPONENT robot EXCLUDE_FROM_ALL)

add_custom_target(robot_programs)
function(darwinop_robot_program TARGET)
  install(TARGETS ${TARGET} RUNTIME DESTINATION bin COMPONENT robot EXCLUDE_FROM_ALL)
  add_dependencies(robot_programs ${TARGET})
  if(CMAKE_CROSSCOMPILING)
    # The linker warns of what a static program cannot do on the robot: look up users, groups and hosts.
    target_link_options(${TARGET} PRIVATE LINKER:--fatal-warnings)
  endif()
endfunction()

install(PROGRAMS installer/boot DESTINATION share/darwinop COMPONENT robot EXCLUDE_FROM_ALL OPTIONAL)
install(FILES installer/robot.ini DESTINATION share/darwinop COMPONENT robot EXCLUDE_FROM_ALL OPTIONAL)
