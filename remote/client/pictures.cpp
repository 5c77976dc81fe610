// Camera pictures of a connection: when to request one, and the newest one received.
#include "remote/client/pictures.hpp"

#include <utility>

#include "remote/client/messages.hpp"
#include "remote/jpeg/decoder.hpp"

namespace darwinop::remote {
namespace {

constexpr Nanos kReportBlackAfter{2'000'000'000};

std::string inPixels(ImageSize size) {
  return std::to_string(size.width) + "x" + std::to_string(size.height);
}

}  // namespace

/// Decodes on access: unused pictures cost no CPU time.
class Pictures::Source final : public FrameSource {
 public:
  Source(Pictures& pictures, std::function<Nanos()> now) : pictures_{pictures}, now_{std::move(now)} {
    ++pictures_.sources_;
  }
  ~Source() override { --pictures_.sources_; }
  Source(const Source&) = delete;
  Source& operator=(const Source&) = delete;

  CameraFrame newest() override {
    pictures_.every_ = std::max(1, pictures_.since_access_);
    pictures_.since_access_ = 0;
    pictures_.has_new_ = false;
    if (seen_ != pictures_.arrived_) decode();
    return frame_;
  }

  [[nodiscard]] CameraHealth health() const override {
    CameraHealth health = health_;
    health.seeing = frame_.sequence != 0 && !pictures_.black_ && now_() - pictures_.confirmed_ < kReportBlackAfter;
    return health;
  }

 private:
  void decode() {
    seen_ = pictures_.arrived_;
    const std::optional<ImageSize> size = imageSizeOf(pictures_.jpeg_);
    const char* error = size ? nullptr : "not a JPEG of a size that servers send";
    if (size) {
      decoded_.resize(4 * static_cast<std::size_t>(size->width) * static_cast<std::size_t>(size->height));
      error = decodeJpeg(pictures_.jpeg_, *size, decoded_);
    }
    if (error != nullptr) {
      if (health_.damaged++ == 0) pictures_.log_(std::string{"Camera: discarded a received picture: "} + error);
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

  /// The cropped picture at its position in 320x240, black around it: objects keep their place and size.
  [[nodiscard]] const std::vector<std::uint8_t>& framed(ImageSize size) {
    framed_.assign(std::size_t{4} * kWholeImage.width * kWholeImage.height, 0);
    for (std::size_t alpha = 3; alpha < framed_.size(); alpha += 4) framed_[alpha] = 255;
    const std::ptrdiff_t bytes = std::ptrdiff_t{4} * size.width;
    for (int row = 0; row < size.height; ++row)
      std::copy_n(decoded_.begin() + bytes * row, bytes,
                  framed_.begin() + 4 * (std::ptrdiff_t{row + topOf(size)} * kWholeImage.width + leftOf(size)));
    if (!std::exchange(logged_crop_, true))
      pictures_.log_("Camera: the server sends only the middle " + inPixels(size) +
                     " of its pictures; the rest is black. For whole pictures start it with: darwinop remote 1 1");
    return framed_;
  }

  Pictures& pictures_;
  std::function<Nanos()> now_;
  std::vector<std::uint8_t> decoded_, framed_;
  CameraFrame frame_{};
  CameraHealth health_{};
  std::uint64_t seen_ = 0;
  bool logged_crop_ = false;
};

bool Pictures::areDue() {
  if (sources_ == 0) return false;
  return ++since_access_ >= every_ && !has_new_;
}

void Pictures::take(const Reply& reply, Nanos now) {
  has_new_ = true;
  const bool known = reply.extension.has_value();
  if (reply.jpeg.empty()) {
    if (known && reply.extension->holds_picture) {
      confirmed_ = now - Nanos{std::int64_t{reply.extension->picture_age_us} * 1000};
      return;
    }
    black_ = true;
    if (!std::exchange(logged_no_camera_, true))
      log_("Camera: every picture is black: the robot's server has no camera");
    return;
  }
  const Nanos age{known ? std::int64_t{reply.extension->picture_age_us} * 1000 : 0};
  black_ = known && reply.extension->picture == 0;
  checkBlack(now);
  held_ = known ? reply.extension->picture : 0;
  taken_ = confirmed_ = now - age;
  ++arrived_;
  jpeg_.assign(reply.jpeg.begin(), reply.jpeg.end());
}

/// Reports black pictures only after kReportBlackAfter, because a camera takes time to open.
void Pictures::checkBlack(Nanos now) {
  if (!black_) {
    black_since_.reset();
    logged_black_ = false;
    return;
  }
  if (!black_since_) black_since_ = now;
  if (now - *black_since_ < kReportBlackAfter || std::exchange(logged_black_, true)) return;
  log_(messages::kRobotsCameraIsBlind);
}

std::optional<ImageSize> Pictures::size() const {
  return imageSizeOf(jpeg_);
}

std::unique_ptr<FrameSource> Pictures::open(std::function<Nanos()> now) {
  return std::make_unique<Source>(*this, std::move(now));
}

}  // namespace darwinop::remote
