// Camera errors, each with a message that includes a remedy.
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

namespace darwinop::v4l2 {

enum class CameraError : std::uint8_t {
  kAbsent,       // no such device node, or no device behind it
  kForbidden,    // no permission
  kBusy,         // used by another program
  kNotACamera,   // a file, a terminal, a tuner
  kNoStreaming,  // no memory-mapped streaming
  kOtherFormat,  // not YUYV
  kOtherSize,    // returned with another size
  kFewBuffers,   // fewer than two
  kNoBandwidth,  // USB bandwidth exhausted
  kUnplugged,    // lost while in use
  kSilent,       // no picture within the time limit
  kDamaged,      // pictures, but no complete one within the time limit
  kReadErrors,   // consecutive read errors
  kOutOfMemory,
  kOther,
  kCount
};

/// Maps the errno of open(), or of a call before the first picture.
[[nodiscard]] CameraError cameraErrorOf(int error);

/// The message. `detail`: what the device delivered, or strerror(); `dev`: the folder that is searched for devices.
[[nodiscard]] std::string explain(CameraError kind, const std::string& device, const std::string& detail = {},
                                  const std::string& dev = "/dev");

/// The message when pictures arrive again after an error.
[[nodiscard]] std::string explainReturn(const std::string& device);

/// Thrown while a camera is opened; what() is the message.
class CameraRefused : public std::runtime_error {
 public:
  CameraRefused(CameraError kind, const std::string& device, const std::string& detail = {})
      : runtime_error{explain(kind, device, detail)}, kind_{kind} {}
  [[nodiscard]] CameraError kind() const noexcept { return kind_; }

 private:
  CameraError kind_;
};

/// Throws CameraRefused for an errno.
[[noreturn]] void refuse(const std::string& device, int error);

/// video* in `dev`, sorted by number.
[[nodiscard]] std::vector<std::string> videoDevices(const std::string& dev = "/dev");

}  // namespace darwinop::v4l2
