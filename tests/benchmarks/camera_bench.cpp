// A camera picture from YUYV to what a controller or an encoder gets, beside other ways to do it. All take turns on the
// same buffers; the best of many turns counts, since whatever else runs on the machine only makes them slower.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <functional>
#include <random>
#include <string>
#include <vector>

#include "five_passes.hpp"
#include "hal/pixels/yuyv_to_bgra.hpp"
#include "hal/pixels/yuyv_to_planes.hpp"

#ifdef DARWINOP_BENCH_LIBYUV
#include <libyuv.h>
#endif

namespace {

using namespace darwinop;
using namespace darwinop::pixels;
using Bytes = std::vector<std::uint8_t>;

constexpr int kTurns = 400;

struct Way {
  std::string name;
  std::function<void()> run;
  std::function<void(bool begins)> around = [](bool) {};  // not timed
  double best_us = 1e9;
};

/// Twice in a row, so that the second time finds its data where it left them.
void takeTurns(std::vector<Way>& ways) {
  for (int turn = 0; turn < kTurns; ++turn)
    for (Way& way : ways) {
      way.around(true);
      for (int twice = 0; twice < 2; ++twice) {
        const auto begin = std::chrono::steady_clock::now();
        way.run();
        const std::chrono::duration<double, std::micro> time = std::chrono::steady_clock::now() - begin;
        way.best_us = std::min(way.best_us, time.count());
      }
      way.around(false);
    }
}

void print(const std::string& prefix, const Way& ours, const Way& peer) {
  std::printf("bench: %s_%s_%s ours=%.2f peer=%.2f ratio=%.3f unit=us\n", prefix.c_str(), ours.name.c_str(),
              peer.name.c_str(), ours.best_us, peer.best_us, ours.best_us / peer.best_us);
}

/// Noise: no way's time depends on what is in the picture.
Bytes noise(std::size_t count) {
  Bytes bytes(count);
  std::mt19937 rng{1};
  for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(rng() >> 24);
  return bytes;
}

/// All buffers of one size of picture, made once.
struct Desk {
  Desk(int w, int h)
      : width{w},
        height{h},
        pixels{static_cast<std::size_t>(w) * h},
        yuyv{noise(2 * pixels)},
        bgra(4 * pixels),
        other(4 * pixels),
        y(pixels),
        u(pixels / 4),
        v(pixels / 4),
        five{w, h} {}
  [[nodiscard]] YuyvImage image() const { return {yuyv, width, height, static_cast<std::size_t>(width) * 2}; }
  [[nodiscard]] Planes planes() { return {y, u, v}; }

  int width, height;
  std::size_t pixels;
  Bytes yuyv, bgra, other, y, u, v;
  bench::FivePasses five;
};

#ifdef DARWINOP_BENCH_LIBYUV
// Only its speed counts here: libyuv's YUY2 has other coefficients (16..235), and rounds differently.

/// Two calls for the whole picture.
void libyuvTurned(Desk& d) {
  libyuv::YUY2ToARGB(d.yuyv.data(), 2 * d.width, d.other.data(), 4 * d.width, d.width, d.height);
  libyuv::ARGBRotate(d.other.data(), 4 * d.width, d.bgra.data(), 4 * d.width, d.width, d.height, libyuv::kRotate180);
}

/// Two calls a row: what lies between them stays in the first cache.
void libyuvRowByRow(Desk& d) {
  for (int y = 0; y < d.height; ++y) {
    libyuv::YUY2ToARGB(d.yuyv.data() + 2 * d.width * y, 2 * d.width, d.other.data(), 4 * d.width, d.width, 1);
    libyuv::ARGBMirror(d.other.data(), 4 * d.width, d.bgra.data() + 4 * d.width * (d.height - 1 - y), 4 * d.width,
                       d.width, 1);
  }
}

/// Keeps libyuv from what an older processor lacks: beside our kernels without AVX2 it shall have none, either.
void onlySsse3(bool begins) {
  libyuv::MaskCpuFlags(begins ? libyuv::kCpuHasX86 | libyuv::kCpuHasSSE2 | libyuv::kCpuHasSSSE3 : -1);
}

void libyuvPlanesOfBgra(Desk& d) {
  libyuv::ARGBToJ420(d.bgra.data(), 4 * d.width, d.y.data(), d.width, d.u.data(), d.width / 2, d.v.data(), d.width / 2,
                     d.width, d.height);
}

/// Without BGRA: to planes, which are then turned.
void libyuvPlanes(Desk& d) {
  std::uint8_t *y = d.other.data(), *u = y + d.pixels, *v = u + d.pixels / 4;
  libyuv::YUY2ToI420(d.yuyv.data(), 2 * d.width, y, d.width, u, d.width / 2, v, d.width / 2, d.width, d.height);
  libyuv::I420Rotate(y, d.width, u, d.width / 2, v, d.width / 2, d.y.data(), d.width, d.u.data(), d.width / 2,
                     d.v.data(), d.width / 2, d.width, d.height, libyuv::kRotate180);
}
#endif

void toBgra(Desk& d, const std::string& prefix) {
  std::vector<Way> ways;
  for (const auto& kernel : bgraKernels())
    if (kernel.usable)
      ways.push_back({std::string{kernel.name}, [&d, &kernel] { kernel.function(d.image(), d.bgra); }});
  const std::size_t ours = ways.size();
  ways.push_back({"memcpy", [&d] { std::copy(d.other.begin(), d.other.end(), d.bgra.begin()); }});
  ways.push_back({"five_passes", [&d] { d.five.run(d.yuyv, d.bgra); }});
#ifdef DARWINOP_BENCH_LIBYUV
  ways.push_back({"libyuv", [&d] { libyuvTurned(d); }});
  ways.push_back({"libyuv_by_row", [&d] { libyuvRowByRow(d); }});
  ways.push_back({"libyuv_by_row_ssse3", [&d] { libyuvRowByRow(d); }, onlySsse3});
#endif
  takeTurns(ways);
  for (std::size_t i = 0; i < ours; ++i)
    for (std::size_t peer = ours; peer < ways.size(); ++peer) print(prefix, ways[i], ways[peer]);
}

void toPlanes(Desk& d, const std::string& prefix) {
  std::vector<Way> ways;
  for (const auto& kernel : planesKernels())
    if (kernel.usable)
      ways.push_back({"planes_" + std::string{kernel.name},
                      [&d, &kernel] { kernel.function(d.image(), Chroma::k420, d.planes()); }});
  const std::size_t ours = ways.size();
  ways.push_back({"bgra_alone", [&d] { yuyvToBgraRotated(d.image(), d.bgra); }});
#ifdef DARWINOP_BENCH_LIBYUV
  ways.push_back({"bgra_then_planes", [&d] {
                    yuyvToBgraRotated(d.image(), d.bgra);
                    libyuvPlanesOfBgra(d);
                  }});
  ways.push_back({"libyuv", [&d] { libyuvPlanes(d); }});
#endif
  takeTurns(ways);
  for (std::size_t i = 0; i < ours; ++i)
    for (std::size_t peer = ours; peer < ways.size(); ++peer) print(prefix, ways[i], ways[peer]);
}

/// The five passes come to the same bytes.
bool plausible(Desk& d) {
  d.five.run(d.yuyv, d.other);
  yuyvToBgraRotated(d.image(), d.bgra);
  return d.other == d.bgra;
}

}  // namespace

int main() {
  for (const auto& [width, height] : {std::pair{320, 240}, {640, 480}}) {
    Desk desk{width, height};
    if (!plausible(desk)) {
      std::fputs("the five passes and the single one differ\n", stderr);
      return 1;
    }
    const std::string prefix = "camera_" + std::to_string(width) + "x" + std::to_string(height);
    toBgra(desk, prefix);
    toPlanes(desk, prefix);
  }
}
