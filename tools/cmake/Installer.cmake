# `darwinop install`: a shell script that stays where it is. Beside the built commands lies a link to it, so that the
# dispatcher finds it; an installed tree gets a copy with everything the script sends.
if(EXISTS "${PROJECT_SOURCE_DIR}/installer/darwinop-install")
  file(MAKE_DIRECTORY "${CMAKE_RUNTIME_OUTPUT_DIRECTORY}")
  file(CREATE_LINK "${PROJECT_SOURCE_DIR}/installer/darwinop-install"
    "${CMAKE_RUNTIME_OUTPUT_DIRECTORY}/darwinop-install" SYMBOLIC)
  install(DIRECTORY installer DESTINATION "${CMAKE_INSTALL_DATADIR}/darwinop" USE_SOURCE_PERMISSIONS
    COMPONENT commands)
  install(FILES rc.local.template DESTINATION "${CMAKE_INSTALL_DATADIR}/darwinop" COMPONENT commands OPTIONAL)
  file(CREATE_LINK "../${CMAKE_INSTALL_DATADIR}/darwinop/installer/darwinop-install"
    "${PROJECT_BINARY_DIR}/darwinop-install" SYMBOLIC)
  install(FILES "${PROJECT_BINARY_DIR}/darwinop-install" DESTINATION bin COMPONENT commands)
endif()
