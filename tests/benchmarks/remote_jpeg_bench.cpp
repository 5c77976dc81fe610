// A camera's frame to the picture in a reply, by planes and by other ways, and back on the client's side. All take
// turns on the same frame; the best of many turns counts, since whatever else runs on the machine only makes them
// slower. Then the same bytes as the picture in a reply: what a step of a controller waits for is the exchange of a
// whole poll through the server, over the loopback, and the unpacking.
//
// With the word "table": a table for people.
#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
// libjpeg's header needs stdio's before it.
#include <jpeglib.h>

#include <functional>
#include <string>
#include <vector>

#include "camera_scene.hpp"
#include "hal/pixels/yuyv_to_bgra.hpp"
#include "remote/jpeg/decoder.hpp"
#include "remote/jpeg/encoder.hpp"
#include "served_poll.hpp"

namespace {

using namespace darwinop;
using namespace darwinop::remote;
using bench::Bytes;
using bench::Frame;
using bench::kPixels;

constexpr int kTurns = 60, kScenes = 8, kExchanges = 60;

/// libjpeg as a program uses it that does no more than needed: heap for each picture, defaults for everything.
struct PlainJpeg {
  PlainJpeg() {
    cinfo.err = jpeg_std_error(&errors);
    jpeg_create_compress(&cinfo);
  }
  ~PlainJpeg() { jpeg_destroy_compress(&cinfo); }
  PlainJpeg(const PlainJpeg&) = delete;
  PlainJpeg& operator=(const PlainJpeg&) = delete;

  std::size_t write(const std::uint8_t* first, std::size_t stride, ImageSize size, J_COLOR_SPACE colours, int quality,
                    Bytes& into) {
    unsigned char* to = into.data();
    auto length = static_cast<unsigned long>(into.size());
    jpeg_mem_dest(&cinfo, &to, &length);
    cinfo.image_width = static_cast<JDIMENSION>(size.width);
    cinfo.image_height = static_cast<JDIMENSION>(size.height);
    cinfo.input_components = colours == JCS_RGB ? 3 : 4;
    cinfo.in_color_space = colours;
    jpeg_set_defaults(&cinfo);
    jpeg_set_quality(&cinfo, quality, TRUE);
    jpeg_start_compress(&cinfo, TRUE);
    while (cinfo.next_scanline < cinfo.image_height) {
      JSAMPROW row = const_cast<JSAMPROW>(first + stride * cinfo.next_scanline);
      jpeg_write_scanlines(&cinfo, &row, 1);
    }
    jpeg_finish_compress(&cinfo);
    return length;
  }

  jpeg_compress_struct cinfo{};
  jpeg_error_mgr errors{};
};

/// From the camera's YUYV to bytes for the wire, and from these to a controller's BGRA. Figures are means over scenes.
struct Way {
  std::string name;
  std::function<std::size_t(const Frame& frame)> pack;
  std::function<void(std::size_t length)> unpack;
  double pack_us = 0, unpack_us = 0, exchange_us = 0, length = 0, square = 0;

  [[nodiscard]] double stepUs() const { return exchange_us + unpack_us; }
  [[nodiscard]] double psnr() const { return 10 * std::log10(255.0 * 255.0 / square); }
};

template <class Work>
double microseconds(Work&& work) {
  const auto begin = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - begin).count();
}

/// Each twice in a row, so that the second time finds its data where it left them.
void takeTurns(std::vector<Way>& ways, const Frame& frame, const Bytes& seen) {
  std::vector<std::array<double, 2>> best(ways.size(), {1e9, 1e9});
  for (int turn = 0; turn < kTurns; ++turn)
    for (std::size_t i = 0; i < ways.size(); ++i)
      for (int twice = 0; twice < 2; ++twice) {
        Way& way = ways[i];
        std::size_t length = 0;
        best[i][0] = std::min(best[i][0], microseconds([&] { length = way.pack(frame); }));
        best[i][1] = std::min(best[i][1], microseconds([&] { way.unpack(length); }));
        if (turn != 0 || twice != 0) continue;
        way.length += static_cast<double>(length) / kScenes;
        way.square += meanSquare(frame, seen) / kScenes;
      }
  for (std::size_t i = 0; i < ways.size(); ++i) {
    ways[i].pack_us += best[i][0] / kScenes;
    ways[i].unpack_us += best[i][1] / kScenes;
  }
}

/// Median time of an exchange whose picture has these bytes.
double exchangeUs(bench::ServingThread& serving, bench::PollingClient& client, Bytes picture) {
  const std::size_t length = picture.size();
  serving.show(std::move(picture));
  std::array<double, kExchanges> us;
  for (double& each : us) each = client.exchange(length);
  std::ranges::nth_element(us, us.begin() + kExchanges / 2);
  return us[kExchanges / 2];
}

void print(const std::string& name, double ours, double peer, const char* unit) {
  std::printf("bench: %s ours=%.2f peer=%.2f ratio=%.3f unit=%s\n", name.c_str(), ours, peer, ours / peer, unit);
}

/// A part of the frame without alpha, in the order that is asked for.
template <int blue, int red>
std::size_t threeBytes(const Bytes& bgra, ImageSize size, Bytes& into) {
  std::uint8_t* to = into.data();
  for (int y = 0; y < size.height; ++y) {
    const std::uint8_t* from = bgra.data() + std::size_t{4} * (320 * (topOf(size) + y) + leftOf(size));
    for (int x = 0; x < size.width; ++x, from += 4, to += 3) {
      to[blue] = from[0];
      to[1] = from[1];
      to[red] = from[2];
    }
  }
  return static_cast<std::size_t>(to - into.data());
}

const Way& named(const std::vector<Way>& ways, const std::string& name) {
  return *std::ranges::find(ways, name, &Way::name);
}

/// A row for the JPEGs of one quality; raw bytes, which have none, below the last one.
void printTable(const std::vector<Way>& ways, ImageSize size, int quality) {
  const Way &planes = named(ways, "planes"), &bgra = named(ways, "bgra");
  std::printf("| %dx%d, %d | %.0f | %.0f | %.2f | %.0f | %.2f | %.2f | %.0f | %.0f | %.0f |\n", size.width, size.height,
              quality, planes.pack_us, bgra.pack_us, bgra.pack_us / planes.pack_us, named(ways, "bgra_2013").pack_us,
              planes.psnr(), bgra.psnr(), planes.length, planes.unpack_us, planes.stepUs());
  if (quality != 50) return;
  for (const char* const raw : {"raw_bgr", "raw_bgra"}) {
    const Way& way = named(ways, raw);
    std::printf("| %dx%d, %s | | %.0f | | | | | %.0f | %.0f | %.0f |\n", size.width, size.height, raw + 4, way.pack_us,
                way.length, way.unpack_us, way.stepUs());
  }
}

bool measure(ImageSize size, int quality, bool table) {
  const std::size_t count = static_cast<std::size_t>(size.width) * size.height, row_bytes = std::size_t{4} * size.width;
  JpegEncoder encoder{size, quality}, bgra_encoder{size, quality};
  PlainJpeg plain;
  Bytes bgra(4 * kPixels), rgb(3 * count), wire(std::max(encoder.mostBytes(), 4 * count)), seen(4 * count);
  const std::uint8_t* first = bgra.data() + std::size_t{4} * (320 * topOf(size) + leftOf(size));
  const auto to_bgra = [&](const Frame& frame) { pixels::yuyvToBgraRotated(frame.image(), bgra); };
  const auto decode = [&](std::size_t length) {
    if (decodeJpeg(std::span{wire}.first(length), size, seen) != nullptr) std::ranges::fill(seen, 0);
  };

  std::vector<Way> ways;
  const auto way = [&](const char* name, auto&& pack, auto&& unpack) { ways.push_back({name, pack, unpack}); };
  way(
      "planes",
      [&](const Frame& frame) {
        return encoder.encode({1, Nanos{0}, 320, 240, {}, frame.yuyv}, wire);
      },
      decode);
  way(
      "bgra",
      [&](const Frame& frame) {
        to_bgra(frame);
        return bgra_encoder.encode({1, Nanos{0}, 320, 240, bgra, {}}, wire);
      },
      decode);
  way(
      "bgra_plain",
      [&](const Frame& frame) {
        to_bgra(frame);
        return plain.write(first, 1280, size, JCS_EXT_BGRX, quality, wire);
      },
      decode);
  // As in 2013: a loop puts the colours into the order that libjpeg knew then.
  way(
      "bgra_2013",
      [&](const Frame& frame) {
        to_bgra(frame);
        threeBytes<2, 0>(bgra, size, rgb);
        return plain.write(rgb.data(), std::size_t{3} * size.width, size, JCS_RGB, quality, wire);
      },
      decode);
  way(
      "raw_bgra",
      [&](const Frame& frame) {
        to_bgra(frame);
        for (int y = 0; y < size.height; ++y) std::copy_n(first + 1280 * y, row_bytes, &wire[row_bytes * y]);
        return 4 * count;
      },
      [&](std::size_t length) { std::copy_n(wire.begin(), length, seen.begin()); });
  way(
      "raw_bgr",
      [&](const Frame& frame) {
        to_bgra(frame);
        return threeBytes<0, 2>(bgra, size, wire);
      },
      [&](std::size_t) {
        const std::uint8_t* from = wire.data();
        for (std::size_t i = 0; i < seen.size(); i += 4, from += 3) {
          std::copy_n(from, 3, &seen[i]);
          seen[i + 3] = 255;
        }
      });
  for (std::uint32_t seed = 1; seed <= kScenes; ++seed) takeTurns(ways, Frame{size, seed}, seen);
  bench::ServingThread serving{bench::ServingThread::anyPort()};
  bench::PollingClient client{bench::connectTo(serving.port())};
  for (std::uint32_t seed = 1; seed <= kScenes; ++seed) {
    const Frame frame{size, seed};
    for (Way& each : ways) {
      const auto length = static_cast<std::ptrdiff_t>(each.pack(frame));
      each.exchange_us += exchangeUs(serving, client, Bytes(wire.begin(), wire.begin() + length)) / kScenes;
    }
  }

  if (table) printTable(ways, size, quality);
  const Way& ours = ways.front();
  for (const Way& peer : ways) {
    if (table || &peer == &ours) continue;
    const std::string name = "remote_jpeg_" + std::to_string(size.width) + "x" + std::to_string(size.height) + "_q" +
                             std::to_string(quality) + "_" + peer.name;
    print(name, ours.pack_us, peer.pack_us, "us");
    print(name + "_unpack", ours.unpack_us, peer.unpack_us, "us");
    print(name + "_bytes", ours.length, peer.length, "bytes");
    print(name + "_psnr", ours.psnr(), peer.psnr(), "dB");
    print(name + "_step", ours.stepUs(), peer.stepUs(), "us");
  }
  return std::ranges::all_of(ways, [](const Way& each) { return each.psnr() > 20; });
}

}  // namespace

int main(int count, char** arguments) {
  const bool table = count > 1 && std::string{arguments[1]} == "table";
  if (table)
    std::puts(
        "| picture, quality | from planes | from BGRA | ratio | as in 2013 | PSNR, dB | from BGRA | bytes | "
        "decompression | step |\n|---|---:|---:|---:|---:|---:|---:|---:|---:|---:|");
  bool sound = true;
  for (const ImageSize size : {ImageSize{160, 120}, kWholeImage})
    for (const int quality : {100, 80, 65, 50}) sound = measure(size, quality, table) && sound;
  if (!sound) std::fputs("a way does not show the picture that the camera took\n", stderr);
  return sound ? 0 : 1;
}
