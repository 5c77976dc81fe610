darwinop_test(twin_effects_test
  effects_catalogue_test.cpp effects_each_test.cpp effects_command_test.cpp effects_controller_test.cpp
  effects_motor_test.cpp effects_friction_test.cpp effects_load_test.cpp ../support/allocation_probe.cpp
  USES twin_bench)

# docs/twin/effects.md is made from the catalogue; this fails when somebody changed one and not the other.
add_executable(print_effects "${PROJECT_SOURCE_DIR}/tools/print_effects.cpp")
target_link_libraries(print_effects PRIVATE darwinop_options twin_effects)
add_test(NAME Docs.EffectsPageMatchesTheCatalogue
  COMMAND print_effects --check "${PROJECT_SOURCE_DIR}/docs/twin/effects.md")
set_tests_properties(Docs.EffectsPageMatchesTheCatalogue PROPERTIES LABELS fast)
