find_package(rapidcheck REQUIRED)
darwinop_test(twin_model_test
  model_docs_test.cpp model_edit_test.cpp model_effects_test.cpp model_errors_test.cpp model_find_test.cpp
  model_read_test.cpp model_shipped_test.cpp
  USES twin_model)
target_compile_definitions(twin_model_test PRIVATE DARWINOP_MODELS_PAGE="${PROJECT_SOURCE_DIR}/docs/twin/models.md"
  DARWINOP_SHIPPED_MODELS="${PROJECT_SOURCE_DIR}/twin/models")
darwinop_test(twin_model_property_test model_property_test.cpp USES twin_model rapidcheck)
