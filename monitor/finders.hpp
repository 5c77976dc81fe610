// What the observers look for, looked for in each picture: in the thread that encodes it, once for all who want the
// same.
#pragma once

#include <array>
#include <cstdint>
#include <mutex>
#include <optional>
#include <vector>

#include "hal/frame_source.hpp"
#include "monitor/wishes.hpp"

namespace darwinop::monitor {

/// What a search found in one picture.
struct Found {
  std::uint64_t picture = 0;                     // its sequence
  int width = 0, height = 0;                     // of the picture
  std::optional<vision::Pixel> centre;           // nothing: too little of the colour, or too much
  std::uint64_t pixels = 0;                      // that have it, behind the taking away of noise
  int left = 0, top = 0, right = 0, bottom = 0;  // what they lie in, both ends included; of no use without pixels
  std::vector<std::uint8_t> mask;  // a bit a pixel, row by row, (width + 7) / 8 bytes each; the lowest is the left one
};

/// want() and found() by one thread, look() by one other: the two wait for each other while a few kilobytes are copied.
class Finders {
 public:
  static constexpr std::size_t kMost = 8;  // searches: no more observers can look on

  /// From the next picture on; those beyond kMost are not looked for.
  void want(const std::vector<Search>& searches);
  /// Another size than the one before makes everything anew.
  void look(const CameraFrame& frame) noexcept;
  /// Nothing: that picture was not looked at for it, or is long gone.
  [[nodiscard]] std::optional<Found> found(const Search& search, std::uint64_t picture) const;

 private:
  static constexpr std::size_t kKept = 4;  // pictures: one may be found in while the one before is still shown

  struct One {
    Search search;
    vision::ColourFinder finder;  // look()'s alone
    std::array<Found, kKept> found{};
  };
  void take(const CameraFrame& frame);

  mutable std::mutex mutex_;  // of wanted_, and of the members of ones_ but for their finders
  std::vector<Search> wanted_;
  std::vector<One> ones_;
  std::vector<std::uint8_t> bgra_;
};

}  // namespace darwinop::monitor
