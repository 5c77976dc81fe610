// Our SIMD kernels beside the same written with Highway, at the same instruction set, over a frame. Both take turns on
// the same buffers; the best of many turns counts, since whatever else runs on the machine only makes them slower.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <functional>
#include <random>
#include <string>
#include <vector>

#include "highway_kernels.hpp"

namespace {

using namespace darwinop;
using Bytes = std::vector<std::uint8_t>;
using Run = std::function<void(Bytes& out)>;

constexpr int kTurns = 400;
constexpr vision::Thresholds kOrange{28, 20, 50, 45};

Bytes noise(std::size_t count) {
  Bytes bytes(count);
  std::mt19937 rng{1};
  for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(rng() >> 24);
  return bytes;
}

double timeOf(const Run& run, Bytes& out) {
  const auto begin = std::chrono::steady_clock::now();
  run(out);
  return std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - begin).count();
}

/// False when the results differ.
bool compare(const std::string& name, std::size_t bytes, const Run& ours, const Run& peer) {
  Bytes our_result(bytes), peer_result(bytes);
  double our_us = 1e9, peer_us = 1e9;
  for (int turn = 0; turn < kTurns; ++turn) {
    our_us = std::min(our_us, timeOf(ours, our_result));
    peer_us = std::min(peer_us, timeOf(peer, peer_result));
  }
  std::printf("bench: highway_%s ours=%.2f peer=%.2f ratio=%.3f unit=us\n", name.c_str(), our_us, peer_us,
              our_us / peer_us);
  if (our_result == peer_result) return true;
  std::fprintf(stderr, "highway_%s: the results differ\n", name.c_str());
  return false;
}

struct Frame {
  int width, height;
  [[nodiscard]] std::size_t pixels() const { return static_cast<std::size_t>(width) * height; }

  /// `row` for each row of the frame; a row has so many bytes.
  template <class Row>
  [[nodiscard]] Run rows(const Bytes& from, int bytes_from, int bytes_to, Row row) const {
    return [=, *this, &from](Bytes& out) {
      for (int y = 0; y < height; ++y) row(from.data() + bytes_from * y, out.data() + bytes_to * y);
    };
  }
};

struct OurKernels {
  pixels::BgraRow* bgra;
  vision::Instructions classify;
};

bool compareAll(const Frame& frame, const std::string& level, const OurKernels& ours,
                const bench::HighwayKernels& highway) {
  const Bytes yuyv = noise(2 * frame.pixels()), bgra = noise(4 * frame.pixels());
  const int w = frame.width;
  const std::string suffix = "_" + std::to_string(w) + "x" + std::to_string(frame.height) + "_" + level;
  const auto bgraBy = [&](pixels::BgraRow* row) {
    return frame.rows(yuyv, 2 * w, 4 * w, [=](auto* from, auto* to) { row(from, w, to); });
  };
  const auto planesBy = [&](pixels::LumaRow* luma, pixels::ChromaRow* chroma) {
    return frame.rows(yuyv, 2 * w, 2 * w, [=](auto* from, auto* to) {
      luma(from, w, to);
      chroma(from, from, w, to + w, to + w + w / 2);
    });
  };
  const vision::ColourTest orange = vision::compile(kOrange);
  const auto classifyBy = [&](vision::Classify classify) {
    return frame.rows(bgra, 4 * w, w / 8, [&orange, w, classify](auto* from, auto* to) {
      classify(orange, from, w, reinterpret_cast<std::uint64_t*>(to));
    });
  };
  bool same = compare("bgra" + suffix, 4 * frame.pixels(), bgraBy(ours.bgra), bgraBy(highway.bgra));
  same &= compare("planes" + suffix, 2 * frame.pixels(), planesBy(pixels::lumaRowSse2, pixels::chromaRowSse2),
                  planesBy(highway.luma, highway.chroma));
  same &= compare("classify" + suffix, frame.pixels() / 8, classifyBy(vision::classifierFor(ours.classify)),
                  classifyBy(highway.classify));
  return same;
}

}  // namespace

int main() {
  bool same = true;
  for (const Frame& frame : {Frame{320, 240}, Frame{640, 480}}) {
    same &= compareAll(frame, "ssse3", {pixels::bgraRowSsse3, vision::Instructions::kSsse3}, bench::highwaySsse3);
    if (vision::canUse(vision::Instructions::kAvx2))
      same &= compareAll(frame, "avx2", {pixels::bgraRowAvx2, vision::Instructions::kAvx2}, bench::highwayAvx2);
  }
  return same ? 0 : 1;
}
