// Checks whether the network is fast enough for the controller's step, and which picture size would be.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "hal/byte_line.hpp"
#include "remote/jpeg/image_size.hpp"

namespace darwinop::remote {

class LinkSpeed {
 public:
  /// One exchange. `network`: time from request to reply, without the server's hold time. `step`: the controller's
  /// step.
  struct Exchange {
    Nanos network{0}, step{0};
    std::size_t picture = 0;  // bytes; 0: none
    std::optional<ImageSize> size{};
  };
  /// Returns a message once, when the network is too slow; otherwise empty.
  [[nodiscard]] std::string note(const Exchange& exchange);

 private:
  [[nodiscard]] std::string message(const Exchange& last) const;

  // Exponential moving averages (weight of a new value: 0.1), ms; a new value is limited to ten steps.
  double plain_ms_ = 0, picture_ms_ = 0, picture_bytes_ = 0;
  int in_window_ = 0, late_ = 0;
  bool reported_ = false;
};

}  // namespace darwinop::remote
