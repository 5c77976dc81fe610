# The twin loaded from its library, behind bus and safety layer.
if(TARGET darwinop_twin)
  darwinop_test(twin_wiring_test wiring_test.cpp USES link)
  target_compile_definitions(twin_wiring_test PRIVATE DARWINOP_TWIN_MODELS="${PROJECT_SOURCE_DIR}/twin/models")
  add_dependencies(twin_wiring_test darwinop_twin)
endif()

# Gyroscope scale from the twin to the monitor's text.
if(TARGET remote_monitor)
  find_package(nlohmann_json REQUIRED)
  darwinop_test(twin_gyro_scale_test gyro_scale_test.cpp
    USES twin_body link remote_monitor logs nlohmann_json::nlohmann_json)
  target_compile_definitions(twin_gyro_scale_test PRIVATE DARWINOP_MODELS="${PROJECT_SOURCE_DIR}/twin/models")
endif()
