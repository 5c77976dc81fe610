// What the monitor adds to a picture when observers ask for what is found in it: from the camera's YUYV to the text
// that goes out. Peer: the picture itself, from the same YUYV to the JPEG. Each takes turns on the same frame; the best
// turn counts.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <string>
#include <vector>

#include "apps/colour_search/frame_search.hpp"
#include "camera_scene.hpp"
#include "monitor/search_message.hpp"
#include "remote/jpeg/encoder.hpp"

namespace {

using namespace darwinop;

template <class Work>
void keepBest(double& best_us, Work&& work) {
  const auto begin = std::chrono::steady_clock::now();
  work();
  const double us = std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - begin).count();
  best_us = std::min(best_us, us);
}

}  // namespace

int main() {
  constexpr int kScenes = 8, kTurns = 200;
  remote::JpegEncoder encoder{remote::kWholeImage, remote::qualityOf(remote::kWholeImage)};
  bench::Bytes jpeg(encoder.mostBytes());
  for (const int searches : {1, static_cast<int>(monitor::ColourSearch::kMost)}) {
    std::vector<monitor::Search> wanted;
    for (int i = 0; i < searches; ++i) wanted.push_back({{.hue = 40 * i}, {}});
    double ours = 0, peer = 0;
    std::size_t bytes = 0;
    for (std::uint32_t seed = 1; seed <= kScenes; ++seed) {
      const bench::Frame scene{remote::kWholeImage, seed};
      colour_search::FrameSearch search_of_frames;
      search_of_frames.want(wanted);
      double find_us = 1e9, encode_us = 1e9;
      for (std::uint64_t turn = 1; turn <= kTurns; ++turn) {
        const CameraFrame frame{turn, Nanos{0}, 320, 240, {}, scene.yuyv};
        keepBest(find_us, [&] {
          search_of_frames.look(frame);
          for (const monitor::Search& search : wanted)
            if (const auto found = search_of_frames.found(search, turn)) bytes = foundText(*found, true).size();
        });
        keepBest(encode_us, [&] { (void)encoder.encode(frame, jpeg); });
      }
      ours += find_us / kScenes;
      peer += encode_us / kScenes;
    }
    if (bytes == 0) return 1;
    std::printf("bench: monitor_find_%d ours=%.1f peer=%.1f ratio=%.3f unit=us\n", searches, ours, peer, ours / peer);
  }
  return 0;
}
