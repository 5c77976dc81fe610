darwinop_test(twin_effects_test
  effects_catalogue_test.cpp effects_each_test.cpp effects_command_test.cpp effects_controller_test.cpp
  effects_motor_test.cpp effects_friction_test.cpp effects_load_test.cpp ../support/allocation_probe.cpp
  USES twin_bench)
