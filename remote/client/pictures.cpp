// The pictures of a connection: when one is asked for, the newest one that came, and who looks at it.
#include "remote/client/pictures.hpp"

#include <utility>

#include "remote/jpeg/decoder.hpp"

namespace darwinop::remote {
namespace {

constexpr Nanos kBlindAfter{2'000'000'000};

std::string inPixels(ImageSize size) {
  return std::to_string(size.width) + "x" + std::to_string(size.height);
}

}  // namespace

/// Decodes when it is looked at: a picture that nobody looks at costs nothing.
class Pictures::Eyes final : public FrameSource {
 public:
  Eyes(Pictures& pictures, std::function<Nanos()> now) : pictures_{pictures}, now_{std::move(now)} {
    ++pictures_.watchers_;
  }
  ~Eyes() override { --pictures_.watchers_; }
  Eyes(const Eyes&) = delete;
  Eyes& operator=(const Eyes&) = delete;

  CameraFrame newest() override {
    pictures_.every_ = std::max(1, pictures_.since_look_);
    pictures_.since_look_ = 0;
    pictures_.had_ = false;
    if (seen_ != pictures_.arrived_) decode();
    return frame_;
  }

  [[nodiscard]] CameraHealth health() const override {
    CameraHealth health = health_;
    health.seeing = frame_.sequence != 0 && !pictures_.blind_ && now_() - pictures_.confirmed_ < kBlindAfter;
    return health;
  }

 private:
  void decode() {
    seen_ = pictures_.arrived_;
    const std::optional<ImageSize> size = imageSizeOf(pictures_.jpeg_);
    const char* wrong = size ? nullptr : "it is no JPEG, or of a size that a server never sends";
    if (size) {
      decoded_.resize(4 * static_cast<std::size_t>(size->width) * static_cast<std::size_t>(size->height));
      wrong = decodeJpeg(pictures_.jpeg_, *size, decoded_);
    }
    if (wrong != nullptr) {
      if (health_.damaged++ == 0) pictures_.say_(std::string{"Camera: a picture that came is not shown: "} + wrong);
      frame_ = {};
      return;
    }
    ++health_.frames;
    frame_ = {.sequence = seen_,
              .time = pictures_.taken_,
              .width = kWholeImage.width,
              .height = kWholeImage.height,
              .bgra = *size == kWholeImage ? decoded_ : framed(*size)};
  }

  /// The middle of a picture where it belongs, black around it: what is seen keeps its place and its size.
  [[nodiscard]] const std::vector<std::uint8_t>& framed(ImageSize size) {
    framed_.assign(std::size_t{4} * kWholeImage.width * kWholeImage.height, 0);
    for (std::size_t alpha = 3; alpha < framed_.size(); alpha += 4) framed_[alpha] = 255;
    const std::ptrdiff_t bytes = std::ptrdiff_t{4} * size.width;
    for (int row = 0; row < size.height; ++row)
      std::copy_n(decoded_.begin() + bytes * row, bytes,
                  framed_.begin() + 4 * (std::ptrdiff_t{row + topOf(size)} * kWholeImage.width + leftOf(size)));
    if (!std::exchange(told_, true))
      pictures_.say_("Camera: the server sends the middle " + inPixels(size) +
                     " of its pictures, the rest is black; the whole ones come from: darwinop remote 1 1");
    return framed_;
  }

  Pictures& pictures_;
  std::function<Nanos()> now_;
  std::vector<std::uint8_t> decoded_, framed_;
  CameraFrame frame_{};
  CameraHealth health_{};
  std::uint64_t seen_ = 0;
  bool told_ = false;
};

bool Pictures::areDue() {
  if (watchers_ == 0) return false;
  return ++since_look_ >= every_ && !had_;
}

void Pictures::take(const Reply& reply, Nanos now) {
  had_ = true;
  const bool known = reply.extension.has_value();
  if (reply.jpeg.empty()) {
    if (known && reply.extension->holds_picture) {
      confirmed_ = now - Nanos{std::int64_t{reply.extension->picture_age_us} * 1000};
      return;
    }
    blind_ = true;
    if (!std::exchange(told_eyeless_, true)) say_("Camera: every picture is black: this robot's server has no camera");
    return;
  }
  const Nanos age{known ? std::int64_t{reply.extension->picture_age_us} * 1000 : 0};
  blind_ = known && reply.extension->picture == 0;
  noticeBlindness(now);
  held_ = known ? reply.extension->picture : 0;
  taken_ = confirmed_ = now - age;
  ++arrived_;
  jpeg_.assign(reply.jpeg.begin(), reply.jpeg.end());
}

/// A camera needs a moment to open.
void Pictures::noticeBlindness(Nanos now) {
  if (!blind_) {
    blind_since_.reset();
    told_blind_ = false;
    return;
  }
  if (!blind_since_) blind_since_ = now;
  if (now - *blind_since_ < kBlindAfter || std::exchange(told_blind_, true)) return;
  say_("Camera: every picture is black: the robot's camera gives none, its server says why");
}

std::optional<ImageSize> Pictures::size() const {
  return imageSizeOf(jpeg_);
}

std::unique_ptr<FrameSource> Pictures::open(std::function<Nanos()> now) {
  return std::make_unique<Eyes>(*this, std::move(now));
}

}  // namespace darwinop::remote
