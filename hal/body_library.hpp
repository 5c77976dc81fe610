// How a body comes out of a shared library: the physics twin is loaded when somebody asks for it, so that controllers
// and robots need no physics library. Plain C functions, so that both sides may come from different compilers.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "hal/body.hpp"

namespace darwinop {

inline constexpr const char* kTwinLibraryFile = "libdarwinop-twin.so";
inline constexpr const char* kBodyLibraryEntry = "darwinop_body_library";

/// A picture that the body's eyes keep until they are asked for the next one: 4 * width * height bytes.
struct BodyPicture {
  std::uint64_t sequence;
  std::int64_t time_ns;
  int width, height;
  const std::uint8_t* bgra;
  const char* blindness;  // why this is a test pattern that says the same; null: the eyes see
};

/// What the entry function returns. No function throws.
struct BodyLibrary {
  const char* version;  // bodyLibraryVersion() of the library's build
  /// `model`: name or file, empty for the usual one. Null: refused, and `error` says why, in at most `size` bytes.
  void* (*make)(const char* model, std::uint64_t seed, char* error, std::size_t size);
  void (*step)(void* body, std::int64_t dt_ns, const ServoDrive* drives);  // kJoints of them
  const BodyState* (*state)(const void* body);
  const char* (*trouble)(const void* body);  // as Body::trouble()
  void (*end)(void* body);
  // Eyes, as hal/body.hpp has them. Null: refused, as with make().
  void* (*open_eyes)(void* body, int width, int height, char* error, std::size_t size);
  void (*look)(void* eyes);
  void (*newest)(void* eyes, BodyPicture* picture);
  void (*close_eyes)(void* eyes);
};
using BodyLibraryEntry = const BodyLibrary* (*)();

/// Differs when the two sides do not understand each other: the release, a number to be raised when a meaning changes,
/// and the sizes of what is handed over.
inline std::string bodyLibraryVersion(const char* release) {
  constexpr int kMeaning = 5;
  std::string text = std::string{release} + ", interface";
  for (const std::size_t part :
       {std::size_t{kMeaning}, kJoints, sizeof(ServoDrive), sizeof(BodyState), sizeof(BodyPicture)})
    text += ' ' + std::to_string(part);
  return text;
}

}  // namespace darwinop
