# Robot body.
darwinop_test(twin_body_test body_file_test.cpp body_kinematics_test.cpp body_mass_test.cpp body_sensors_test.cpp
  body_physics_test.cpp body_errors_test.cpp
  USES twin_body body_xml rapidcheck)
# Each simulates tens of seconds.
darwinop_test(twin_body_run_test body_joints_test.cpp body_balance_test.cpp body_start_pose_test.cpp
  USES twin_body LABELS long)
foreach(program twin_body_test twin_body_run_test)
  target_compile_definitions(${program} PRIVATE DARWINOP_MODELS="${PROJECT_SOURCE_DIR}/twin/models")
endforeach()
