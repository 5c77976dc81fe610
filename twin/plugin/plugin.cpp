// C interface of the twin's shared library (BodyLibrary in hal/body_library.hpp).
#include <cstring>
#include <exception>
#include <memory>
#include <string>

#include "hal/body_library.hpp"
#include "twin/body/robot_body.hpp"
#include "twin/model/model.hpp"
#include "twin/render/head_camera.hpp"

namespace darwinop::twin {
namespace {

constexpr const char* kDefaultModel = "darwin-op";

void copyError(const char* message, char* error, std::size_t size) {
  if (size == 0) return;
  std::strncpy(error, message, size - 1);
  error[size - 1] = '\0';
}

/// Result of `make`; null if it throws, with the message in `error`. Exceptions must not cross the C interface.
template <class Make>
void* orError(char* error, std::size_t size, Make&& make) {
  try {
    return make();
  } catch (const std::exception& wrong) {
    copyError(wrong.what(), error, size);
  } catch (...) {
    copyError("cannot create the twin: unknown exception", error, size);
  }
  return nullptr;
}

void* make(const char* model, std::uint64_t seed, char* error, std::size_t size) {
  return orError(error, size, [&] {
    const std::string name = *model == '\0' ? kDefaultModel : model;
    const RobotBodyOptions options{.seed = seed,
                                   .ball = ballFromEnvironment(),
                                   .ball_colour = ballColourFromEnvironment(),
                                   .clamped_up = clampFromEnvironment()};
    return std::make_unique<RobotBody>(readModel(findModel(name)), options).release();
  });
}

void step(void* body, std::int64_t dt_ns, const ServoDrive* drives) {
  Drives all;
  std::memcpy(all.data(), drives, sizeof all);
  static_cast<RobotBody*>(body)->step(Nanos{dt_ns}, all);
}

const BodyState* state(const void* body) {
  return &static_cast<const RobotBody*>(body)->state();
}

const char* error(const void* body) {
  return static_cast<const RobotBody*>(body)->error();
}

bool clamp(void* body, const double* up) {
  return static_cast<RobotBody*>(body)->clamp({up[0], up[1], up[2]});
}

void end(void* body) {
  delete static_cast<RobotBody*>(body);
}

void* openCamera(void* body, int width, int height, char* error, std::size_t size) {
  return orError(error, size, [&] {
    const HeadCamera::Options options{.width = width, .height = height};
    return std::make_unique<HeadCamera>(*static_cast<RobotBody*>(body), options).release();
  });
}

void look(void* camera) {
  static_cast<HeadCamera*>(camera)->look();
}

void newest(void* camera, BodyPicture* picture) {
  HeadCamera& head = *static_cast<HeadCamera*>(camera);
  const CameraFrame frame = head.newest();
  *picture = {frame.sequence, frame.time.count(), frame.width, frame.height, frame.bgra.data(), head.renderError()};
}

void closeCamera(void* camera) {
  delete static_cast<HeadCamera*>(camera);
}

}  // namespace
}  // namespace darwinop::twin

extern "C" const darwinop::BodyLibrary* darwinop_body_library() {
  static const std::string version = darwinop::bodyLibraryVersion(DARWINOP_VERSION);
  static const darwinop::BodyLibrary library{.version = version.c_str(),
                                             .make = darwinop::twin::make,
                                             .step = darwinop::twin::step,
                                             .state = darwinop::twin::state,
                                             .error = darwinop::twin::error,
                                             .clamp = darwinop::twin::clamp,
                                             .end = darwinop::twin::end,
                                             .open_camera = darwinop::twin::openCamera,
                                             .look = darwinop::twin::look,
                                             .newest = darwinop::twin::newest,
                                             .close_camera = darwinop::twin::closeCamera};
  return &library;
}
