// Is the network fast enough for the controller's steps? And which pictures would it carry in time?
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "hal/byte_line.hpp"
#include "remote/jpeg/image_size.hpp"

namespace darwinop::remote {

class LinkSpeed {
 public:
  /// One exchange. `network`: from the request to its reply, without what the server held it back. `step`: what the
  /// controller gives it. A sentence, once, when the link is too slow; else empty.
  struct Exchange {
    Nanos network{0}, step{0};
    std::size_t picture = 0;  // bytes; 0: none
    std::optional<ImageSize> size{};
  };
  [[nodiscard]] std::string note(const Exchange& exchange);

 private:
  [[nodiscard]] std::string sentence(const Exchange& last) const;

  // Moving figures, ms: nine parts of what was, one of what is new, which counts for ten steps at most.
  double plain_ms_ = 0, picture_ms_ = 0, picture_bytes_ = 0;
  int in_window_ = 0, late_ = 0;
  bool told_ = false;
};

}  // namespace darwinop::remote
