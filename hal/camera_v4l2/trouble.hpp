// What can be wrong with a camera, each with a sentence that says what to do.
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

namespace darwinop::v4l2 {

enum class Trouble : std::uint8_t {
  kAbsent,       // no such device, or none behind its name
  kForbidden,    // no permission
  kBusy,         // somebody else uses it
  kNotACamera,   // a file, a terminal, a tuner
  kNoStreaming,  // a camera without memory-mapped pictures
  kOtherFormat,  // no YUYV
  kOtherSize,    // came back with another size than it had
  kFewBuffers,   // less than two
  kNoBandwidth,  // the USB bus is full
  kUnplugged,    // went away while in use
  kSilent,       // no picture for a while
  kDamaged,      // pictures, but no whole one for a while
  kReadErrors,   // one after the other
  kOutOfMemory,
  kOther,
  kCount
};

/// Which trouble an errno of open() or of a call on the way to the first picture means.
[[nodiscard]] Trouble troubleOf(int error);

/// The sentence. `detail` is what the device gave instead, or what the system calls the error; `dev` is where devices
/// are looked for.
[[nodiscard]] std::string explain(Trouble trouble, const std::string& device, const std::string& detail = {},
                                  const std::string& dev = "/dev");

/// Thrown while a camera is being opened; what() is the sentence.
class CameraRefused : public std::runtime_error {
 public:
  CameraRefused(Trouble trouble, const std::string& device, const std::string& detail = {})
      : runtime_error{explain(trouble, device, detail)}, trouble_{trouble} {}
  [[nodiscard]] Trouble trouble() const noexcept { return trouble_; }

 private:
  Trouble trouble_;
};

/// CameraRefused for an errno.
[[noreturn]] void refuse(const std::string& device, int error);

/// video* in `dev`, sorted by number.
[[nodiscard]] std::vector<std::string> videoDevices(const std::string& dev = "/dev");

}  // namespace darwinop::v4l2
