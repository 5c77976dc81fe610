#include "apps/colour_search/frame_search.hpp"

#include <algorithm>
#include <bit>
#include <exception>
#include <span>
#include <utility>

#include "hal/pixels/yuyv_to_bgra.hpp"

namespace darwinop::colour_search {
using monitor::Found;
using monitor::Search;

namespace {

/// What lies in the finder's mask, and the mask itself.
void describe(const vision::BitRows& mask, Found& found) {
  const std::size_t row_bytes = (static_cast<std::size_t>(mask.width()) + 7) / 8;
  found.width = found.left = mask.width();
  found.height = found.top = mask.height();
  found.right = found.bottom = -1;
  found.pixels = 0;
  found.mask.clear();
  for (int y = 0; y < mask.height(); ++y) {
    const std::span<const std::uint64_t> row = mask.row(y);
    for (std::size_t i = 0; i < row_bytes; ++i)
      found.mask.push_back(static_cast<std::uint8_t>(row[i / 8] >> (8 * (i % 8)) & 0xFF));
    for (std::size_t i = 0; i < row.size(); ++i) {
      if (row[i] == 0) continue;
      const int first = static_cast<int>(64 * i);
      found.pixels += static_cast<std::uint64_t>(std::popcount(row[i]));
      found.left = std::min(found.left, first + std::countr_zero(row[i]));
      found.right = std::max(found.right, first + 63 - std::countl_zero(row[i]));
      found.top = std::min(found.top, y);
      found.bottom = y;
    }
  }
}

}  // namespace

void FrameSearch::want(const std::vector<Search>& searches) {
  std::vector<Search> different;
  for (const Search& search : searches)
    if (different.size() < kMost && std::ranges::find(different, search) == different.end())
      different.push_back(search);
  const std::lock_guard lock{mutex_};
  wanted_ = std::move(different);
}

void FrameSearch::look(const CameraFrame& frame) noexcept try { take(frame); } catch (const std::exception&) {
  return;  // no memory, or a picture of no size: nothing is found
}

void FrameSearch::take(const CameraFrame& frame) {
  {
    const std::lock_guard lock{mutex_};
    const auto wanted = [this](const One& one) { return std::ranges::find(wanted_, one.search) != wanted_.end(); };
    std::erase_if(ones_, [&](const One& one) {
      return !wanted(one) || one.finder.width() != frame.width || one.finder.height() != frame.height;
    });
    for (const Search& search : wanted_)
      if (std::ranges::find(ones_, search, &One::search) == ones_.end())
        ones_.push_back({search, vision::ColourFinder{frame.width, frame.height, search.colour, search.limits}});
  }
  if (ones_.empty()) return;
  std::span<const std::uint8_t> bgra = frame.bgra;
  if (bgra.empty()) {
    bgra_.resize(4 * static_cast<std::size_t>(frame.width) * static_cast<std::size_t>(frame.height));
    const pixels::YuyvImage image{frame.yuyv, frame.width, frame.height, pixels::yuyvRowBytes(frame.width)};
    if (!pixels::isWhole(image)) return;
    pixels::yuyvToBgraRotated(image, bgra_);
    bgra = bgra_;
  }
  for (One& one : ones_) {
    Found found;
    found.picture = frame.sequence;
    found.centre = one.finder.find(bgra);
    describe(one.finder.mask(), found);
    const std::lock_guard lock{mutex_};
    one.found[frame.sequence % kKept] = std::move(found);
  }
}

std::optional<Found> FrameSearch::found(const Search& search, std::uint64_t picture) const {
  const std::lock_guard lock{mutex_};
  const auto one = std::ranges::find(ones_, search, &One::search);
  if (one == ones_.end() || picture == 0) return std::nullopt;
  const Found& found = one->found[picture % kKept];
  return found.picture == picture ? std::optional{found} : std::nullopt;
}

}  // namespace darwinop::colour_search
