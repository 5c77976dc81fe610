// Colour search of the monitor: runs in the thread that encodes the frames, once for all observers with equal
// parameters.
#pragma once

#include <array>
#include <cstdint>
#include <mutex>
#include <optional>
#include <vector>

#include "managers/vision/colour_finder.hpp"
#include "monitor/colour_search.hpp"

namespace darwinop::colour_search {

/// Calls block each other only while a few kilobytes are copied under a mutex.
class FrameSearch final : public monitor::ColourSearch {
 public:
  void setSearches(const std::vector<monitor::ColourQuery>& searches) override;
  /// A frame of another size discards earlier results.
  void process(const CameraFrame& frame) noexcept override;
  [[nodiscard]] std::optional<monitor::ColourMatch> resultOf(const monitor::ColourQuery& search,
                                                             std::uint64_t picture) const override;

 private:
  static constexpr std::size_t kKept =
      4;  // frames: results of earlier frames are read while the next active is searched

  struct ActiveSearch {
    monitor::ColourQuery search;
    vision::ColourFinder finder;  // used by process() only
    std::array<monitor::ColourMatch, kKept> results{};
  };
  void searchFrame(const CameraFrame& frame);

  mutable std::mutex mutex_;  // guards wanted_ and active_, except for the finders
  std::vector<monitor::ColourQuery> wanted_;
  std::vector<ActiveSearch> active_;
  std::vector<std::uint8_t> bgra_;
};

}  // namespace darwinop::colour_search
