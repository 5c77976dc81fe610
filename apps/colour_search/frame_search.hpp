// Searches camera frames for the colours that observers of the monitor ask for: in the thread that encodes the frames,
// once for all who want the same.
#pragma once

#include <array>
#include <cstdint>
#include <mutex>
#include <optional>
#include <vector>

#include "managers/vision/colour_finder.hpp"
#include "monitor/colour_search.hpp"

namespace darwinop::colour_search {

/// want() and found() wait for look(), and look() for them, while a few kilobytes are copied.
class FrameSearch final : public monitor::ColourSearch {
 public:
  void want(const std::vector<monitor::Search>& searches) override;
  /// A frame of another size discards what was found.
  void look(const CameraFrame& frame) noexcept override;
  [[nodiscard]] std::optional<monitor::Found> found(const monitor::Search& search,
                                                    std::uint64_t picture) const override;

 private:
  static constexpr std::size_t kKept = 4;  // pictures: one may be found in while the one before is still shown

  struct One {
    monitor::Search search;
    vision::ColourFinder finder;  // look()'s alone
    std::array<monitor::Found, kKept> found{};
  };
  void take(const CameraFrame& frame);

  mutable std::mutex mutex_;  // of wanted_, and of the members of ones_ but for their finders
  std::vector<monitor::Search> wanted_;
  std::vector<One> ones_;
  std::vector<std::uint8_t> bgra_;
};

}  // namespace darwinop::colour_search
