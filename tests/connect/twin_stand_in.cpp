// A library as the twin's, whose joints are at once where they shall be. TWIN_VERSION: what it says it is,
// TWIN_ENTRY: the name of its one function.
#include <cstring>

#include "hal/body_library.hpp"

namespace {

using darwinop::BodyState;
using darwinop::ServoDrive;

void* make(const char* model, std::uint64_t seed, char* error, std::size_t size) {
  if (std::strcmp(model, "refused") == 0) {
    std::strncpy(error, "refused, line 3: no such key", size - 1);
    return nullptr;
  }
  auto* const state = new BodyState;
  state->joint[0].temperature_c = static_cast<double>(seed);
  return state;
}

void step(void* body, std::int64_t dt_ns, const ServoDrive* drives) {
  auto& state = *static_cast<BodyState*>(body);
  for (std::size_t i = 0; i < darwinop::kJoints; ++i) state.joint[i].position_rad = drives[i].goal_rad;
  state.gyro_rad_s[0] += static_cast<double>(dt_ns);
}

const BodyState* state(const void* body) {
  return static_cast<const BodyState*>(body);
}

const char* error(const void* /*body*/) {
  return nullptr;
}

bool clamp(void* /*body*/, const double* /*up*/) {
  return false;
}

void end(void* body) {
  delete static_cast<BodyState*>(body);
}

// Eyes that see one pixel; blue counts the looks. At the third they are blind.
struct OnePixel {
  std::uint64_t looks = 0;
  std::uint8_t bgra[4] = {0, 0, 0, 255};
};

void* openCamera(void* /*body*/, int width, int /*height*/, char* error, std::size_t size) {
  if (width > 1) {
    std::strncpy(error, "these eyes see one pixel", size - 1);
    return nullptr;
  }
  return new OnePixel;
}

void look(void* camera) {
  auto& pixel = *static_cast<OnePixel*>(camera);
  pixel.bgra[0] = static_cast<std::uint8_t>(++pixel.looks);
}

void newest(void* camera, darwinop::BodyPicture* picture) {
  const auto& pixel = *static_cast<OnePixel*>(camera);
  *picture = {pixel.looks, static_cast<std::int64_t>(pixel.looks) * 1000, 1, 1,
              pixel.bgra,  pixel.looks < 3 ? nullptr : "it is dark"};
}

void closeCamera(void* camera) {
  delete static_cast<OnePixel*>(camera);
}

}  // namespace

extern "C" const darwinop::BodyLibrary* TWIN_ENTRY() {
  static const std::string version = darwinop::bodyLibraryVersion(TWIN_VERSION);
  static const darwinop::BodyLibrary library{version.c_str(), make, step,   state,      error, clamp, end,
                                             openCamera,      look, newest, closeCamera};
  return &library;
}
