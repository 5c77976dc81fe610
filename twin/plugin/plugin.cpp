// The physics twin as a shared library: makes bodies for whoever loads it.
#include <cstring>
#include <exception>
#include <memory>
#include <string>

#include "hal/body_library.hpp"
#include "twin/body/robot_body.hpp"
#include "twin/model/model.hpp"

namespace darwinop::twin {
namespace {

constexpr const char* kUsualModel = "darwin-op";

void tell(const char* sentence, char* error, std::size_t size) {
  if (size == 0) return;
  std::strncpy(error, sentence, size - 1);
  error[size - 1] = '\0';
}

void* make(const char* model, std::uint64_t seed, char* error, std::size_t size) {
  try {
    const std::string name = *model == '\0' ? kUsualModel : model;
    return std::make_unique<RobotBody>(readModel(findModel(name)), RobotBodyOptions{.seed = seed}).release();
  } catch (const std::exception& wrong) {
    tell(wrong.what(), error, size);
  } catch (...) {
    tell("the twin cannot be made, for a reason that it does not tell", error, size);
  }
  return nullptr;
}

void step(void* body, std::int64_t dt_ns, const ServoDrive* drives) {
  Drives all;
  std::memcpy(all.data(), drives, sizeof all);
  static_cast<RobotBody*>(body)->step(Nanos{dt_ns}, all);
}

const BodyState* state(const void* body) {
  return &static_cast<const RobotBody*>(body)->state();
}

const char* trouble(const void* body) {
  return static_cast<const RobotBody*>(body)->trouble();
}

void end(void* body) {
  delete static_cast<RobotBody*>(body);
}

}  // namespace
}  // namespace darwinop::twin

extern "C" const darwinop::BodyLibrary* darwinop_body_library() {
  static const std::string version = darwinop::bodyLibraryVersion(DARWINOP_VERSION);
  static const darwinop::BodyLibrary library{version.c_str(),       darwinop::twin::make,    darwinop::twin::step,
                                             darwinop::twin::state, darwinop::twin::trouble, darwinop::twin::end};
  return &library;
}
