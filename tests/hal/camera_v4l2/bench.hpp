// Test bench: a virtual camera, its painter, and a log capture.
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "hal/camera_v4l2/camera.hpp"
#include "hal/camera_v4l2/camera_error.hpp"
#include "hal/camera_v4l2/negotiate.hpp"
#include "hil-mocks/camera/frame_painter.hpp"
#include "support/temporary_folder.hpp"

namespace darwinop::v4l2 {

using hil::CameraFault;
using namespace std::chrono_literals;

template <class Condition>
bool waitFor(Condition&& met) {
  const auto limit = std::chrono::steady_clock::now() + 20s;
  while (!met()) {
    if (std::chrono::steady_clock::now() > limit) return false;
    std::this_thread::sleep_for(1ms);
  }
  return true;
}

/// Byte of picture `number`: noise that differs between pictures.
inline std::uint8_t noise(std::uint32_t number, std::size_t at) {
  const std::uint32_t mixed = (static_cast<std::uint32_t>(at) + 977 * number) * 2654435761u;
  return static_cast<std::uint8_t>(mixed >> 23);
}

/// The message about the virtual camera.
inline std::string messageOf(CameraError kind, const std::string& detail = {}) {
  return explain(kind, "/dev/video0", detail);
}
inline std::string messageOfReturn() {
  return explainReturn("/dev/video0");
}

class VirtualCamera {
 public:
  VirtualCamera() {
    ::setenv("DARWINOP_VIRTUAL_CAMERA", painter_.path().c_str(), 1);
    paint(1, kFallback);
  }

  void fault(CameraFault fault) { painter_.setFault(fault); }

  void paint(std::uint32_t number, Size size) {
    std::vector<std::uint8_t> bytes(2u * static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height));
    for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = noise(number, i);
    painter_.paintYuyv({size.width, size.height}, bytes);
  }

 private:
  TemporaryFolder folder_;
  hil::FramePainter painter_{folder_ / "camera"};
};

/// Records log messages.
class LogCapture {
 public:
  std::function<void(const std::string&)> callback() {
    return [this](const std::string& sentence) {
      const std::lock_guard lock{mutex_};
      lines_.push_back(sentence);
    };
  }
  std::vector<std::string> lines() {
    const std::lock_guard lock{mutex_};
    return lines_;
  }
  /// Number of messages that contain `words`.
  int times(const std::string& words) {
    const auto all = lines();
    return static_cast<int>(std::count_if(all.begin(), all.end(), [&](const std::string& sentence) {
      return sentence.find(words) != std::string::npos;
    }));
  }
  bool receives(const std::string& words) {
    return waitFor([&] { return times(words) > 0; });
  }

 private:
  std::mutex mutex_;
  std::vector<std::string> lines_;
};

/// Short retry and silence times. Waits for the thread at the end, so that it cannot use the next test's camera.
inline CameraOptions fastOptions(LogCapture& log) {
  CameraOptions options;
  options.log = log.callback();
  options.patience = {700ms, 5ms, 20ms, 20s};
  return options;
}

inline CameraFrame waitForPicture(Camera& camera, std::uint64_t newer_than = 0) {
  CameraFrame frame;
  EXPECT_TRUE(waitFor([&] { return (frame = camera.newest()).sequence > newer_than; })) << "no picture came";
  return frame;
}

inline bool waitForFrames(const Camera& camera, std::uint64_t more) {
  const std::uint64_t goal = camera.health().frames + more;
  return waitFor([&] { return camera.health().frames >= goal; });
}

/// Number of pixels that differ from picture `number`; the camera's picture may be larger than the frame.
inline int wrongPixels(const CameraFrame& frame, std::uint32_t number, std::size_t stride) {
  int wrong = 0;
  for (int y = 0; y < frame.height; ++y)
    for (int x = 0; x < frame.width; ++x) {
      // Rotated by 180 degrees: the camera is mounted upside down.
      const auto from_x = static_cast<std::size_t>(frame.width - 1 - x);
      const std::size_t row = static_cast<std::size_t>(frame.height - 1 - y) * stride;
      const std::size_t pair = row + from_x / 2 * 4;
      const int luma = 256 * noise(number, row + 2 * from_x);
      const int u = noise(number, pair + 1) - 128, v = noise(number, pair + 3) - 128;
      const auto limit = [](int value) { return std::clamp(value >> 8, 0, 255); };
      const std::uint8_t* is =
          frame.bgra.data() +
          4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(frame.width) + static_cast<std::size_t>(x));
      if (is[0] != limit(luma + 454 * u) || is[1] != limit(luma - 88 * u - 183 * v) || is[2] != limit(luma + 359 * v) ||
          is[3] != 255)
        ++wrong;
    }
  return wrong;
}
inline int wrongPixels(const CameraFrame& frame, std::uint32_t number) {
  return wrongPixels(frame, number, 2u * static_cast<std::size_t>(frame.width));
}

}  // namespace darwinop::v4l2
