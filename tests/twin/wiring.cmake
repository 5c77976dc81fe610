# The twin behind bus and safety layer, loaded from its library as by a controller.
if(TARGET darwinop_twin)
  darwinop_test(twin_wiring_test wiring_test.cpp USES link)
  target_compile_definitions(twin_wiring_test PRIVATE DARWINOP_TWIN_MODELS="${PROJECT_SOURCE_DIR}/twin/models")
  add_dependencies(twin_wiring_test darwinop_twin)
endif()
