// Kernels with Highway. Compiled once for each instruction set; HIGHWAY_KERNELS names the result.
#include "highway_kernels.hpp"

#define HWY_COMPILE_ONLY_STATIC
#include <hwy/highway.h>

namespace darwinop::bench {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

using Bytes = hn::ScalableTag<std::uint8_t>;
using Signed = hn::ScalableTag<std::int8_t>;
using Words = hn::ScalableTag<std::uint16_t>;
using Ints = hn::ScalableTag<std::int16_t>;
using Pairs = hn::ScalableTag<std::uint32_t>;
using Sums = hn::ScalableTag<std::int32_t>;
using VBytes = hn::Vec<Bytes>;
using VWords = hn::Vec<Words>;
using VInts = hn::Vec<Ints>;

constexpr Bytes kBytes;
constexpr Signed kSigned;
constexpr Words kWords;
constexpr Ints kInts;
constexpr Pairs kPairs;
constexpr Sums kSums;
constexpr int kStep = HWY_LANES(std::uint8_t);  // bytes of a register
constexpr int kBlocks = kStep / 16;

/// The same 16 bytes for every block.
VBytes perBlock(const std::uint8_t (&of_16)[16]) {
  return hn::LoadDup128(kBytes, of_16);
}

/// The pairs of a register in reverse order, arranged such that interleaving within blocks ends in the order of memory.
auto reversedPairs() {
  alignas(64) std::int32_t lane[kStep / 4];
  for (int block = 0; block < kBlocks; ++block)
    for (int i = 0; i < 4; ++i)
      lane[4 * block + i] = kStep / 4 - 1 - (i < 2 ? 2 * block + i : 2 * kBlocks + 2 * block + i - 2);
  return hn::SetTableIndices(kPairs, lane);
}

void bgraRow(const std::uint8_t* yuyv, int width, std::uint8_t* bgra) noexcept {
  alignas(16) static constexpr std::uint8_t kTurn[16] = {2, 1, 0, 3, 6, 5, 4, 7, 10, 9, 8, 11, 14, 13, 12, 15};
  alignas(16) static constexpr std::uint8_t kTurnAll[16] = {14, 13, 12, 15, 10, 9, 8, 11, 6, 5, 4, 7, 2, 1, 0, 3};
  alignas(16) static constexpr std::uint8_t kLow[16] = {0, 1, 0, 1, 4, 5, 4, 5, 8, 9, 8, 9, 12, 13, 12, 13};
  alignas(16) static constexpr std::uint8_t kHigh[16] = {2, 3, 2, 3, 6, 7, 6, 7, 10, 11, 10, 11, 14, 15, 14, 15};
  const auto order = reversedPairs();
  const auto words = [](int u, int v) { return (v & 0xffff) << 16 | (u & 0xffff); };
  const VInts blue_red_factor = hn::BitCast(kInts, hn::Set(kSums, words(pixels::kBlueU, pixels::kRedV)));
  const VInts green_factor = hn::BitCast(kInts, hn::Set(kSums, words(pixels::kGreenU, pixels::kGreenV)));
  const VWords luma_mask = hn::Set(kWords, 0x00ff), chroma_mask = hn::Set(kWords, 0xff00),
               middle = hn::Set(kWords, 0x8000);
  const VInts zero = hn::Zero(kInts), most = hn::Set(kInts, 255);
  const VWords alpha = hn::Set(kWords, 0xff00);
  int left = width;
  for (; left >= kStep / 2; left -= kStep / 2, bgra += 2 * kStep) {
    VBytes turned = hn::LoadU(kBytes, yuyv + 2 * (left - kStep / 2));
    if constexpr (kBlocks == 1)
      turned = hn::TableLookupBytes(turned, perBlock(kTurnAll));
    else
      turned = hn::TableLookupBytes(hn::BitCast(kBytes, hn::TableLookupLanes(hn::BitCast(kPairs, turned), order)),
                                    perBlock(kTurn));
    const VInts luma = hn::BitCast(kInts, hn::And(hn::BitCast(kWords, turned), luma_mask));
    const VInts chroma =
        hn::BitCast(kInts, hn::Xor(hn::And(hn::BitCast(kWords, turned), chroma_mask), middle));  // 256 u, 256 v
    const VInts blue_red = hn::MulHigh(chroma, blue_red_factor);
    auto odd = hn::Zero(kSums);
    const auto even = hn::ReorderWidenMulAccumulate(kSums, chroma, green_factor, hn::Zero(kSums), odd);
    const VInts green = hn::BitCast(kInts, hn::RearrangeToOddPlusEven(even, odd));
    const auto added = [&](VInts chroma_term, const std::uint8_t(&words_of)[16]) {
      const VInts sum = hn::Add(luma, hn::TableLookupBytes(chroma_term, hn::BitCast(kInts, perBlock(words_of))));
      return hn::BitCast(kWords, hn::Min(hn::Max(sum, zero), most));
    };
    const VWords b = added(blue_red, kLow), g = added(green, kHigh), r = added(blue_red, kHigh);
    const VWords bg = hn::Or(b, hn::ShiftLeft<8>(g)), ra = hn::Or(r, alpha);
    hn::StoreU(hn::BitCast(kBytes, hn::InterleaveLower(kWords, bg, ra)), kBytes, bgra);
    hn::StoreU(hn::BitCast(kBytes, hn::InterleaveUpper(kWords, bg, ra)), kBytes, bgra + kStep);
  }
  pixels::bgraRowScalar(yuyv, left, bgra);
}

/// The registers of 2 * kStep bytes with their pairs in reverse order: the last ones first.
struct Turned {
  explicit Turned(const std::uint8_t* yuyv)
      : first{hn::BitCast(kBytes, hn::Reverse(kPairs, hn::BitCast(kPairs, hn::LoadU(kBytes, yuyv + kStep))))},
        second{hn::BitCast(kBytes, hn::Reverse(kPairs, hn::BitCast(kPairs, hn::LoadU(kBytes, yuyv))))} {}
  VBytes first, second;
};

void lumaRow(const std::uint8_t* yuyv, int width, std::uint8_t* y) noexcept {
  int left = width;
  for (; left >= kStep; left -= kStep, y += kStep) {
    const Turned turned{yuyv + 2 * (left - kStep)};
    const VWords luma = hn::BitCast(kWords, hn::ConcatEven(kBytes, turned.second, turned.first));
    hn::StoreU(hn::BitCast(kBytes, hn::Or(hn::ShiftLeft<8>(luma), hn::ShiftRight<8>(luma))), kBytes, y);
  }
  pixels::lumaRowScalar(yuyv, left, y);
}

void chromaRow(const std::uint8_t* upper, const std::uint8_t* lower, int width, std::uint8_t* u,
               std::uint8_t* v) noexcept {
  const hn::Half<Bytes> half;
  int left = width;
  for (; left >= kStep; left -= kStep, u += kStep / 2, v += kStep / 2) {
    const Turned a{upper + 2 * (left - kStep)}, b{lower + 2 * (left - kStep)};
    const VBytes mean =
        hn::AverageRound(hn::ConcatOdd(kBytes, a.second, a.first), hn::ConcatOdd(kBytes, b.second, b.first));
    hn::StoreU(hn::LowerHalf(half, hn::ConcatEven(kBytes, mean, mean)), half, u);
    hn::StoreU(hn::LowerHalf(half, hn::ConcatOdd(kBytes, mean, mean)), half, v);
  }
  pixels::chromaRowScalar(upper, lower, left, u, v);
}

/// As vision::ClassifyKernel, but products are made of even and odd bytes apart: Highway has no product of byte pairs.
class Classifier {
 public:
  explicit Classifier(const vision::ColourTest& test)
      : first_{hn::LoadDup128(kSigned, test.minus_first)},
        end_{hn::LoadDup128(kSigned, test.minus_end)},
        least_most_{hn::Set(kBytes, test.least_most)},
        factor_{hn::Set(kWords, static_cast<std::uint16_t>(test.least_factor_low + test.least_factor_high))},
        outside_{hn::Set(kWords, test.outside ? 0xffff : 0)},
        grey_{hn::Set(kBytes, test.grey ? 0xff : 0)} {}

  void bits(const std::uint8_t* bgra, std::uint8_t* bits) const {
    const VBytes p0 = hn::LoadU(kBytes, bgra), p1 = hn::LoadU(kBytes, bgra + kStep);
    const VBytes p2 = hn::LoadU(kBytes, bgra + 2 * kStep), p3 = hn::LoadU(kBytes, bgra + 3 * kStep);
    const VBytes br01 = hn::ConcatEven(kBytes, p1, p0), br23 = hn::ConcatEven(kBytes, p3, p2);
    const VBytes ga01 = hn::ConcatOdd(kBytes, p1, p0), ga23 = hn::ConcatOdd(kBytes, p3, p2);
    const VBytes b = hn::ConcatEven(kBytes, br23, br01), r = hn::ConcatOdd(kBytes, br23, br01);
    const VBytes g = hn::ConcatEven(kBytes, ga23, ga01);

    const VBytes low = hn::Min(r, g), high = hn::Max(r, g);
    const VBytes least = hn::Min(low, b), most = hn::Max(high, b), middle = hn::Max(low, hn::Min(high, b));
    const VBytes range = hn::Sub(most, least);
    const VBytes is_grey = hn::VecFromMask(kBytes, hn::Eq(range, hn::Zero(kBytes)));
    const auto bit = [](auto mask, std::uint8_t value) {
      return hn::And(hn::VecFromMask(kBytes, mask), hn::Set(kBytes, value));
    };
    const VBytes order = hn::Or(hn::Or(bit(hn::Eq(high, r), 1), bit(notLess(g, b), 2)), bit(notLess(b, r), 4));
    const auto first = hn::TableLookupBytes(first_, hn::BitCast(kSigned, order));
    const VBytes has_hue =
        hn::BitCast(kBytes, hn::VecFromMask(kSigned, hn::Gt(first, hn::Set(kSigned, -vision::kNever))));
    const VBytes may_be =
        hn::And(hn::VecFromMask(kBytes, notLess(most, least_most_)), hn::Or(has_hue, hn::BitCast(kBytes, outside_)));
    const VBytes grey = hn::And(is_grey, grey_);
    if (hn::AllFalse(kBytes, hn::MaskFromVec(may_be))) return store(grey, bits);

    const auto end = hn::TableLookupBytes(end_, hn::BitCast(kSigned, order));
    const VWords even = hn::Set(kWords, 0x00ff);
    const auto evenOf = [&](VBytes v) { return hn::And(hn::BitCast(kWords, v), even); };
    const auto oddOf = [](VBytes v) { return hn::ShiftRight<8>(hn::BitCast(kWords, v)); };
    const auto evenSigned = [](auto v) { return hn::ShiftRight<8>(hn::ShiftLeft<8>(hn::BitCast(kInts, v))); };
    const auto oddSigned = [](auto v) { return hn::ShiftRight<8>(hn::BitCast(kInts, v)); };
    const VBytes part = hn::Sub(middle, least);
    const VWords bad_even =
        bad(evenOf(part), evenOf(range), evenSigned(first), evenSigned(end), evenOf(most), evenOf(least));
    const VWords bad_odd = bad(oddOf(part), oddOf(range), oddSigned(first), oddSigned(end), oddOf(most), oddOf(least));
    const VBytes bad_all = hn::OddEven(hn::BitCast(kBytes, bad_odd), hn::BitCast(kBytes, bad_even));
    store(hn::Or(hn::AndNot(hn::Or(bad_all, is_grey), may_be), grey), bits);
  }

 private:
  static hn::Mask<Bytes> notLess(VBytes a, VBytes b) { return hn::Eq(hn::Max(a, b), a); }
  static void store(VBytes all, std::uint8_t* bits) { hn::StoreMaskBits(kBytes, hn::Ne(all, hn::Zero(kBytes)), bits); }

  /// All bits where saturation or hue do not match.
  VWords bad(VWords part, VWords range, VInts first, VInts end, VWords most, VWords least) const {
    const VInts sixty = hn::Mul(hn::BitCast(kInts, part), hn::Set(kInts, 60)), r = hn::BitCast(kInts, range);
    const VInts zero = hn::Zero(kInts);
    const auto since_first = hn::VecFromMask(kInts, hn::Lt(hn::Add(sixty, hn::Mul(r, first)), zero));
    const auto before_end = hn::VecFromMask(kInts, hn::Lt(hn::Add(sixty, hn::Mul(r, end)), zero));
    const VWords in = hn::BitCast(kWords, hn::AndNot(since_first, before_end));
    const VWords hue = hn::Not(hn::Xor(in, outside_));
    const VWords most_scaled = hn::Mul(most, factor_), least_scaled = hn::Mul(least, hn::Set(kWords, 255));
    const VWords grey_enough =
        hn::VecFromMask(kWords, hn::Ne(hn::SaturatedSub(least_scaled, most_scaled), hn::Zero(kWords)));
    return hn::Or(hue, grey_enough);
  }

  hn::Vec<Signed> first_, end_;
  VBytes least_most_;
  VWords factor_, outside_;
  VBytes grey_;
};

void classify(const vision::ColourTest& test, const std::uint8_t* bgra, int width, std::uint64_t* bits) {
  const Classifier classifier{test};
  auto* to = reinterpret_cast<std::uint8_t*>(bits);
  for (int x = 0; x < width; x += kStep, bgra += 4 * kStep, to += kStep / 8) classifier.bits(bgra, to);
}

}  // namespace

const HighwayKernels HIGHWAY_KERNELS{bgraRow, lumaRow, chromaRow, classify};

}  // namespace darwinop::bench
