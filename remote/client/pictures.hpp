// Camera pictures of a connection: when to request one, and the newest one received.
#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "hal/frame_source.hpp"
#include "remote/jpeg/image_size.hpp"
#include "remote/protocol/reply.hpp"

namespace darwinop::remote {

/// Used by the controller's thread only.
class Pictures {
 public:
  using Log = std::function<void(const std::string&)>;
  explicit Pictures(Log log) : log_{std::move(log)} {}

  /// Called before each request: whether to request a picture. Requested just before the controller's next access: with
  /// a
  /// sampling period of four steps, every fourth reply has a picture, and a new one.
  [[nodiscard]] bool areDue();
  /// Number of the newest picture received, which the server need not send again; 0: none.
  [[nodiscard]] std::uint32_t held() const { return held_; }

  /// Size of the newest picture; nullopt: none received.
  [[nodiscard]] std::optional<ImageSize> size() const;

  /// Stores the picture of a reply to a request with a picture.
  void take(const Reply& reply, Nanos now);
  /// For a new connection: the server numbers its pictures from the start.
  void forgetHeld() { held_ = 0; }

  /// A frame source, always 320x240. `now` is the clock of take(). This object must outlive it.
  [[nodiscard]] std::unique_ptr<FrameSource> open(std::function<Nanos()> now);

 private:
  class Source;
  void checkBlack(Nanos now);

  Log log_;
  int sources_ = 0, since_access_ = 0, every_ = 1;
  bool has_new_ = false;  // a picture was received since the last access
  std::vector<std::uint8_t> jpeg_;
  std::uint64_t arrived_ = 0;  // pictures received so far; number of the newest one
  std::uint32_t held_ = 0;
  bool black_ = true, logged_no_camera_ = false, logged_black_ = false;
  std::optional<Nanos> black_since_;
  Nanos taken_{0}, confirmed_{0};  // when the newest picture was taken; when the server last had a new one
};

}  // namespace darwinop::remote
