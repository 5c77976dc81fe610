# Rendering, and darwinop twin view.
darwinop_test(twin_render_test render_head_camera_test.cpp render_picture_test.cpp render_film_test.cpp
  USES twin_view twin_render twin_model)
darwinop_test(twin_view_test render_view_test.cpp USES twin_render LABELS slow)
target_compile_definitions(twin_view_test PRIVATE DARWINOP_BIN="${CMAKE_RUNTIME_OUTPUT_DIRECTORY}"
  DARWINOP_CONTROLLER="$<TARGET_FILE:01_hello_head>")
add_dependencies(twin_view_test darwinop-twin darwinop-run 01_hello_head)
