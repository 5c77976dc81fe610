// The colour finder beside OpenCV's chain of the same steps, and beside a plain one a pixel at a time as robots had it
// in 2013 (docs/performance.md). Built without OpenCV it has the plain peer alone.
#ifdef DARWINOP_BENCH_OPENCV
#include <opencv2/imgproc.hpp>
#endif

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <ctime>
#include <random>
#include <string>
#include <vector>

#include "managers/vision/colour_finder.hpp"

namespace {

using namespace darwinop::vision;

constexpr Thresholds kOrange{28, 20, 50, 45};
constexpr PercentLimits kLimits{0, 30};

struct Image {
  int width, height;
  std::vector<std::uint8_t> bgra;
};

/// Any colour everywhere: nothing can be guessed, and next to nothing is found.
Image noise(int width, int height) {
  Image image{width, height, std::vector<std::uint8_t>(static_cast<std::size_t>(4 * width * height))};
  std::mt19937 rng{1};
  for (std::uint8_t& byte : image.bgra) byte = static_cast<std::uint8_t>(rng());
  return image;
}

/// A green field with white lines under a grey wall, an orange ball, and a camera's noise on all of it.
Image scene(int width, int height) {
  Image image = noise(width, height);
  const int radius = height / 8, ball_x = width * 5 / 8, ball_y = height * 5 / 8;
  std::uint8_t* pixel = image.bgra.data();
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x, pixel += 4) {
      const int dx = x - ball_x, dy = y - ball_y;
      int blue = 40, green = 120, red = 45;
      if (dx * dx + dy * dy < radius * radius)
        blue = 25, green = 110, red = 220;
      else if (y < height / 4)
        blue = green = red = 130;
      else if (y / 3 % 20 == 0 || (x + y) / 4 % 40 == 0)
        blue = green = red = 215;
      const int colours[] = {blue, green, red};
      for (int i = 0; i < 3; ++i) pixel[i] = static_cast<std::uint8_t>(colours[i] + pixel[i] % 21);
    }
  return image;
}

/// As in 2013: colours converted with divisions into a buffer, a mask of bytes, nine reads a pixel, twice.
class Plain {
 public:
  explicit Plain(const Image& image) : image_{image}, hsv_(pixels()), mask_(pixels()), other_(pixels()) {}

  std::optional<Pixel> find() {
    for (std::size_t i = 0; i < hsv_.size(); ++i)
      hsv_[i] = toHsv(image_.bgra[4 * i + 2], image_.bgra[4 * i + 1], image_.bgra[4 * i]);
    for (std::size_t i = 0; i < hsv_.size(); ++i) mask_[i] = matches(hsv_[i], kOrange);
    nine(mask_, other_, 9);
    nine(other_, mask_, 1);
    long count = 0, sum_x = 0, sum_y = 0;
    const std::uint8_t* pixel = mask_.data();
    for (int y = 0; y < image_.height; ++y)
      for (int x = 0; x < image_.width; ++x)
        if (*pixel++ != 0) ++count, sum_x += x, sum_y += y;
    const double all = static_cast<double>(pixels()), part = static_cast<double>(count);
    if (count == 0 || part <= all * kLimits.min / 100 || part > all * kLimits.max / 100) return {};
    return Pixel{static_cast<int>(sum_x / count), static_cast<int>(sum_y / count)};
  }

 private:
  [[nodiscard]] std::size_t pixels() const { return image_.bgra.size() / 4; }

  void nine(const std::vector<std::uint8_t>& from, std::vector<std::uint8_t>& to, int wanted) const {
    std::ranges::fill(to, std::uint8_t{0});
    const int width = image_.width;
    for (int y = 1; y < image_.height - 1; ++y)
      for (int x = 1; x < width - 1; ++x) {
        const std::uint8_t* p = from.data() + y * width + x;
        const int count =
            p[-width - 1] + p[-width] + p[-width + 1] + p[-1] + p[0] + p[1] + p[width - 1] + p[width] + p[width + 1];
        to.data()[y * width + x] = count >= wanted;
      }
  }

  const Image& image_;
  std::vector<Hsv> hsv_;
  std::vector<std::uint8_t> mask_, other_;
};

#ifdef DARWINOP_BENCH_OPENCV
/// The same steps by OpenCV: hue in steps of two degrees, saturation and value of 255, its own rounding.
class OpenCv {
 public:
  explicit OpenCv(Image& image) : bgra_{image.height, image.width, CV_8UC4, image.bgra.data()} { cv::setNumThreads(1); }
  std::optional<Pixel> find() {
    cv::cvtColor(bgra_, hsv_, cv::COLOR_BGR2HSV);
    cv::inRange(hsv_, cv::Scalar(5, 128, 115), cv::Scalar(23, 255, 255), mask_);
    cv::erode(mask_, other_, cv::Mat{});
    cv::dilate(other_, mask_, cv::Mat{});
    const cv::Moments sum = cv::moments(mask_, true);
    const double all = static_cast<double>(bgra_.total());
    if (sum.m00 <= all * kLimits.min / 100 || sum.m00 > all * kLimits.max / 100) return {};
    return Pixel{static_cast<int>(sum.m10 / sum.m00), static_cast<int>(sum.m01 / sum.m00)};
  }

 private:
  cv::Mat bgra_, hsv_, mask_, other_;
};
#endif

std::string textOf(const std::optional<Pixel>& ball) {
  return ball ? std::to_string(ball->x) + " " + std::to_string(ball->y) : "nothing";
}

/// Best CPU time of a call so far, in us, over batches of about a millisecond.
class Timer {
 public:
  template <class Call>
  void run(Call&& call) {
    const double begin = now();
    for (int i = 0; i < batch_; ++i) call();
    const double time = now() - begin;
    best_ = std::min(best_, time / batch_);
    if (time < 1000) batch_ *= 2;
  }
  [[nodiscard]] double best() const { return best_; }

 private:
  static double now() {
    timespec time{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return 1e6 * static_cast<double>(time.tv_sec) + 1e-3 * static_cast<double>(time.tv_nsec);
  }
  double best_ = 1e9;
  int batch_ = 1;
};

void print(const std::string& name, double ours, double peer) {
  std::printf("bench: %s ours=%.2f peer=%.2f ratio=%.3f unit=us\n", name.c_str(), ours, peer, ours / peer);
  std::fflush(stdout);
}

void compare(const std::string& name, Image image) {
  constexpr int kTurns = 120;
  ColourFinder finder{image.width, image.height, kOrange, kLimits};
  Plain plain{image};
  Timer our_time, plain_time;
  if (finder.find(image.bgra) != plain.find()) std::printf("NOT THE SAME: ");
#ifdef DARWINOP_BENCH_OPENCV
  OpenCv opencv{image};
  Timer opencv_time;
  std::printf("%s: ours %s, OpenCV %s\n", name.c_str(), textOf(finder.find(image.bgra)).c_str(),
              textOf(opencv.find()).c_str());
#else
  std::printf("%s: ours %s\n", name.c_str(), textOf(finder.find(image.bgra)).c_str());
#endif
  // In turns, so that whatever else runs on the machine disturbs all of them.
  for (int turn = 0; turn < kTurns; ++turn) {
    our_time.run([&] { finder.find(image.bgra); });
    plain_time.run([&] { plain.find(); });
#ifdef DARWINOP_BENCH_OPENCV
    opencv_time.run([&] { opencv.find(); });
#endif
  }
#ifdef DARWINOP_BENCH_OPENCV
  print("vision_" + name + "_opencv", our_time.best(), opencv_time.best());
#endif
  print("vision_" + name + "_plain", our_time.best(), plain_time.best());
  // Where a processor has less.
  for (const auto& [instructions, what] :
       {std::pair{Instructions::kSsse3, "ssse3"}, {Instructions::kPlain, "portable"}}) {
    if (!canUse(instructions) || instructions == bestInstructions()) continue;
    ColourFinder older{image.width, image.height, kOrange, kLimits, instructions};
    Timer older_time;
    for (int turn = 0; turn < kTurns / 4; ++turn) older_time.run([&] { older.find(image.bgra); });
    print("vision_" + name + "_" + what + "_plain", older_time.best(), plain_time.best());
  }
}

}  // namespace

int main() {
  for (const auto& [width, height] : {std::pair{320, 240}, {640, 480}}) {
    const std::string size = std::to_string(width) + "x" + std::to_string(height);
    compare("scene_" + size, scene(width, height));
    compare("noise_" + size, noise(width, height));
  }
}
