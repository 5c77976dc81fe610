// The pictures of a connection: when one is asked for, the newest one that came, and who looks at it.
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

/// Used by the controller's thread, as the link that it belongs to.
class Pictures {
 public:
  using Say = std::function<void(const std::string&)>;
  explicit Pictures(Say say) : say_{std::move(say)} {}

  /// Before each request: is a picture to be in the reply? The one just before it is looked at: a controller whose
  /// camera has a sampling period of four steps gets every fourth one, and a new one.
  [[nodiscard]] bool areDue();
  /// Number of the one that is here, for a server that need not send it again; 0: none.
  [[nodiscard]] std::uint32_t held() const { return held_; }

  /// Of the newest one; nothing when none came.
  [[nodiscard]] std::optional<ImageSize> size() const;

  /// What came for it.
  void take(const Reply& reply, Nanos now);
  /// The next server counts pictures anew.
  void forgetHeld() { held_ = 0; }

  /// Who looks at them; always 320x240. `now` is the clock of take(). This must outlive it.
  [[nodiscard]] std::unique_ptr<FrameSource> open(std::function<Nanos()> now);

 private:
  class Eyes;
  void noticeBlindness(Nanos now);

  Say say_;
  int watchers_ = 0, since_look_ = 0, every_ = 1;
  bool had_ = false;  // since it was last looked
  std::vector<std::uint8_t> jpeg_;
  std::uint64_t arrived_ = 0;  // pictures so far; number of the newest one
  std::uint32_t held_ = 0;
  bool blind_ = true, told_eyeless_ = false, told_blind_ = false;
  std::optional<Nanos> blind_since_;
  Nanos taken_{0},
      confirmed_{0};  // when the newest one was taken; when the server last had a picture that is new to it
};

}  // namespace darwinop::remote
