find_package(rapidcheck REQUIRED)
darwinop_test(twin_servo_test
  bench_convergence_test.cpp bench_errors_test.cpp bench_findings_test.cpp bench_pendulum_test.cpp
  bench_release_test.cpp servo_heat_test.cpp servo_law_test.cpp servo_motor_test.cpp servo_registers_test.cpp
  servo_transmission_test.cpp
  USES twin_bench)
darwinop_test(twin_servo_property_test servo_friction_property_test.cpp servo_profile_property_test.cpp
  USES twin_bench rapidcheck)
