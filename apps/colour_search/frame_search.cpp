// Colour search of the monitor, run in the encoder thread.
#include "apps/colour_search/frame_search.hpp"

#include <algorithm>
#include <bit>
#include <exception>
#include <span>
#include <utility>

#include "hal/pixels/yuyv_to_bgra.hpp"

namespace darwinop::colour_search {
using monitor::ColourMatch;
using monitor::ColourQuery;

namespace {

/// Computes pixel count, bounding box and packed mask of a finder's mask.
void describe(const vision::BitRows& mask, ColourMatch& found) {
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

void FrameSearch::setSearches(const std::vector<ColourQuery>& searches) {
  std::vector<ColourQuery> different;
  for (const ColourQuery& search : searches)
    if (different.size() < kMost && std::ranges::find(different, search) == different.end())
      different.push_back(search);
  const std::lock_guard lock{mutex_};
  wanted_ = std::move(different);
}

void FrameSearch::process(const CameraFrame& frame) noexcept try { searchFrame(frame); } catch (const std::exception&) {
  return;  // out of memory, or an empty frame: no result
}

void FrameSearch::searchFrame(const CameraFrame& frame) {
  {
    const std::lock_guard lock{mutex_};
    const auto wanted = [this](const ActiveSearch& active) {
      return std::ranges::find(wanted_, active.search) != wanted_.end();
    };
    std::erase_if(active_, [&](const ActiveSearch& active) {
      return !wanted(active) || active.finder.width() != frame.width || active.finder.height() != frame.height;
    });
    for (const ColourQuery& search : wanted_)
      if (std::ranges::find(active_, search, &ActiveSearch::search) == active_.end())
        active_.push_back({search, vision::ColourFinder{frame.width, frame.height, search.colour, search.limits}});
  }
  if (active_.empty()) return;
  std::span<const std::uint8_t> bgra = frame.bgra;
  if (bgra.empty()) {
    bgra_.resize(4 * static_cast<std::size_t>(frame.width) * static_cast<std::size_t>(frame.height));
    const pixels::YuyvImage image{frame.yuyv, frame.width, frame.height, pixels::yuyvRowBytes(frame.width)};
    if (!pixels::isWhole(image)) return;
    pixels::yuyvToBgraRotated(image, bgra_);
    bgra = bgra_;
  }
  for (ActiveSearch& active : active_) {
    ColourMatch found;
    found.picture = frame.sequence;
    found.centre = active.finder.find(bgra);
    describe(active.finder.mask(), found);
    const std::lock_guard lock{mutex_};
    active.results[frame.sequence % kKept] = std::move(found);
  }
}

std::optional<ColourMatch> FrameSearch::resultOf(const ColourQuery& search, std::uint64_t picture) const {
  const std::lock_guard lock{mutex_};
  const auto active = std::ranges::find(active_, search, &ActiveSearch::search);
  if (active == active_.end() || picture == 0) return std::nullopt;
  const ColourMatch& found = active->results[picture % kKept];
  return found.picture == picture ? std::optional{found} : std::nullopt;
}

}  // namespace darwinop::colour_search
