// C interface of a body in a shared library. The twin is loaded on demand, so that controllers and robots do not depend
// on a physics library; plain C, so that both sides may use different compilers.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "hal/body.hpp"

namespace darwinop {

inline constexpr const char* kTwinLibraryFile = "libdarwinop-twin.so";
inline constexpr const char* kBodyLibraryEntry = "darwinop_body_library";

/// A picture: 4 * width * height bytes, valid until the next request.
struct BodyPicture {
  std::uint64_t sequence;
  std::int64_t time_ns;
  int width, height;
  const std::uint8_t* bgra;
  const char* render_error;  // error message if the picture is a test pattern that shows it; null: no error
};

/// The function table. No function throws.
struct BodyLibrary {
  const char* version;  // bodyLibraryVersion() of the library's build
  /// `model`: name or file, empty for the default. Null on failure; `error` then has a message of at most `size` bytes.
  void* (*make)(const char* model, std::uint64_t seed, char* error, std::size_t size);
  void (*step)(void* body, std::int64_t dt_ns, const ServoDrive* drives);  // array of kJoints
  const BodyState* (*state)(const void* body);
  const char* (*error)(const void* body);       // as Body::error()
  bool (*clamp)(void* body, const double* up);  // as Body::clamp()
  void (*end)(void* body);
  // Camera, as in hal/body.hpp. Null on failure, as with make().
  void* (*open_camera)(void* body, int width, int height, char* error, std::size_t size);
  void (*look)(void* camera);
  void (*newest)(void* camera, BodyPicture* picture);
  void (*close_camera)(void* camera);
};
using BodyLibraryEntry = const BodyLibrary* (*)();

/// Differs between incompatible builds: release, an interface number (increase it when a meaning changes), and the
/// sizes of the shared types.
inline std::string bodyLibraryVersion(const char* release) {
  constexpr int kMeaning = 6;
  std::string text = std::string{release} + ", interface";
  for (const std::size_t part :
       {std::size_t{kMeaning}, kJoints, sizeof(ServoDrive), sizeof(BodyState), sizeof(BodyPicture)})
    text += ' ' + std::to_string(part);
  return text;
}

}  // namespace darwinop
