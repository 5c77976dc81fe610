// Nothing is read outside the picture and nothing written outside the output: pages without access lie on both sides.
#include <gtest/gtest.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cstring>
#include <span>

#include "hal/pixels/bgra_to_yuyv.hpp"
#include "hal/pixels/pictures.hpp"
#include "hal/pixels/yuyv_to_planes.hpp"

namespace darwinop::pixels {
namespace {

/// Some pages between two that may not be touched. What touches them ends the test program.
class FencedPages {
 public:
  FencedPages() {
    void* all = ::mmap(nullptr, kInside + 2 * page_, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (all == MAP_FAILED) std::abort();
    inside_ = static_cast<std::uint8_t*>(all) + page_;
    if (::mprotect(inside_, kInside, PROT_READ | PROT_WRITE) != 0) std::abort();
    std::memset(inside_, kUntouched, kInside);
  }
  FencedPages(const FencedPages&) = delete;
  FencedPages& operator=(const FencedPages&) = delete;
  ~FencedPages() { ::munmap(inside_ - page_, kInside + 2 * page_); }

  /// `count` bytes, from `offset` bytes behind the first fence or up to as many before the second.
  std::span<std::uint8_t> place(std::size_t count, bool at_end, std::size_t offset) {
    place_ = {inside_ + (at_end ? kInside - count - offset : offset), count};
    return place_;
  }

  /// Whether all around the last place is as it was.
  [[nodiscard]] bool restUntouched() const {
    const auto untouched = [](const std::uint8_t* begin, const std::uint8_t* end) {
      return std::memcmp(begin, kClear.data(), static_cast<std::size_t>(end - begin)) == 0;
    };
    return untouched(inside_, place_.data()) && untouched(place_.data() + place_.size(), inside_ + kInside);
  }

  void clear() { std::memset(inside_, kUntouched, kInside); }

 private:
  static constexpr std::size_t kInside = 16384;  // a multiple of any page here
  static constexpr std::uint8_t kUntouched = 0xA5;
  inline static const std::vector<std::uint8_t> kClear = std::vector<std::uint8_t>(kInside, kUntouched);
  std::size_t page_ = static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
  std::uint8_t* inside_ = nullptr;
  std::span<std::uint8_t> place_;
};

/// Sizes about the steps of 8 and 16 pixels, at both fences, at every alignment.
template <class Check>
void forEachPlace(Check check) {
  for (const int width : {1, 2, 7, 8, 9, 15, 16, 17, 30, 31, 32, 33, 34, 48, 50})
    for (const int height : {1, 2, 3})
      for (const bool at_end : {false, true})
        for (std::size_t offset = 0; offset < 16; ++offset) {
          SCOPED_TRACE(testing::Message()
                       << width << "x" << height << (at_end ? ", end" : ", begin") << ", " << offset);
          check(pictureOf(width, height, offset % 3, 5), at_end, offset);
          if (testing::Test::HasFailure()) return;
        }
}

YuyvImage fenced(FencedPages& pages, const Picture& picture, bool at_end, std::size_t offset) {
  const auto bytes = pages.place(picture.bytes.size(), at_end, offset);
  std::memcpy(bytes.data(), picture.bytes.data(), bytes.size());
  return {bytes, picture.width, picture.height, picture.stride};
}

TEST(MemoryBounds, BgraFromAndToAnyAlignment) {
  FencedPages from, to;
  forEachPlace([&](const Picture& picture, bool at_end, std::size_t offset) {
    const YuyvImage image = fenced(from, picture, at_end, offset);
    const auto expected = expectedBgra(picture);
    const auto bgra = to.place(expected.size(), at_end, (offset * 5 + 3) % 16 * (offset != 0));
    for (const auto& kernel : usable(bgraKernels())) {
      to.clear();
      kernel.function(image, bgra);
      EXPECT_TRUE(std::ranges::equal(bgra, expected)) << kernel.name;
      EXPECT_TRUE(to.restUntouched()) << kernel.name;
    }
  });
}

TEST(MemoryBounds, PlanesFromAndToAnyAlignment) {
  FencedPages from, y, u, v;
  forEachPlace([&](const Picture& picture, bool at_end, std::size_t offset) {
    const YuyvImage image = fenced(from, picture, at_end, offset);
    for (const Chroma chroma : {Chroma::k422, Chroma::k420}) {
      const std::size_t samples = chromaBytes(picture.width, picture.height, chroma);
      const Planes planes{y.place(static_cast<std::size_t>(picture.width) * picture.height, at_end,
                                  (offset * 5 + 3) % 16 * (offset != 0)),
                          u.place(samples, at_end, offset), v.place(samples, at_end, offset)};
      for (const auto& kernel : usable(planesKernels())) {
        for (FencedPages* pages : {&y, &u, &v}) pages->clear();
        kernel.function(image, chroma, planes);
        for (const FencedPages* pages : {&y, &u, &v}) EXPECT_TRUE(pages->restUntouched()) << kernel.name;
      }
    }
  });
}

TEST(MemoryBounds, BackToYuyv) {
  FencedPages from, to;
  forEachPlace([&](const Picture& picture, bool at_end, std::size_t offset) {
    const auto colours = expectedBgra(picture);
    const auto bgra = from.place(colours.size(), at_end, offset);
    std::ranges::copy(colours, bgra.begin());
    const auto yuyv = to.place(picture.bytes.size(), at_end, offset);
    to.clear();
    bgraToYuyvRotated(bgra, picture.width, picture.height, yuyv, picture.stride);
    EXPECT_TRUE(to.restUntouched());
  });
}

}  // namespace
}  // namespace darwinop::pixels
