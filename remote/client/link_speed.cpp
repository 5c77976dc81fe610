// Checks whether the network is fast enough for the controller's step, and which picture size would be.
#include "remote/client/link_speed.hpp"

#include <algorithm>

#include "core/text/formatted.hpp"
#include "remote/client/messages.hpp"

namespace darwinop::remote {
namespace {

constexpr int kWindow = 128;  // exchanges: about 2 s at 16 ms
constexpr double kCoarserBits =
    2;  // bytes per pixel of smaller sizes relative to 320x240: JPEG quality 80 instead of 65

double inMilliseconds(Nanos time) {
  return std::chrono::duration<double, std::milli>(time).count();
}

void average(double& figure, double now) {
  figure = figure == 0 ? now : (9 * figure + now) / 10;
}

std::string pixels(ImageSize size) {
  return std::to_string(size.width) + "x" + std::to_string(size.height);
}

double bytesOf(ImageSize size, ImageSize now, double bytes_now) {
  const double area = static_cast<double>(size.width * size.height) / (now.width * now.height);
  return bytes_now * area * (now == kWholeImage && size != now ? kCoarserBits : 1);
}

}  // namespace

std::string LinkSpeed::note(const Exchange& exchange) {
  if (reported_ || exchange.step <= Nanos{0}) return {};
  const double took = inMilliseconds(std::min(exchange.network, 10 * exchange.step));
  if (exchange.picture > 0) {
    average(picture_ms_, took);
    average(picture_bytes_, static_cast<double>(exchange.picture));
  } else {
    average(plain_ms_, took);
  }
  if (exchange.network > exchange.step) ++late_;
  if (++in_window_ < kWindow) return {};
  const bool too_slow = 2 * late_ > in_window_;
  in_window_ = late_ = 0;
  if (!too_slow) return {};
  reported_ = true;
  return message(exchange);
}

std::string LinkSpeed::message(const Exchange& last) const {
  const double step = inMilliseconds(last.step);
  std::string text = messages::kNetworkTooSlow +
                     text::formatted("%.0f ms: an exchange takes %.0f ms", step, std::max(plain_ms_, picture_ms_));
  const double for_picture = std::max(0.0, picture_ms_ - plain_ms_);
  if (picture_ms_ == 0 || !last.size) return text + "; no smaller picture would help. Use a cable, or a longer step";
  text += text::formatted(", %.0f ms of it for the %.0f bytes of a picture of ", for_picture, picture_bytes_) +
          pixels(*last.size);
  for (std::size_t i = 0; i < kImageWidths.size(); ++i) {
    const ImageSize size{kImageWidths[i], kImageHeights[i]};
    if (size.width * size.height >= last.size->width * last.size->height) continue;
    const double would_take =
        plain_ms_ + for_picture * bytesOf(size, *last.size, picture_bytes_) / std::max(1.0, picture_bytes_);
    if (would_take > step) continue;
    const std::string zooms =
        text::formatted("%d %d", kWholeImage.width / size.width, kWholeImage.height / size.height);
    return text + ". The middle " + pixels(size) + messages::kSizeFits + zooms;
  }
  return text + "; no size would fit. Use a cable, a longer step, or a longer sampling period of the camera";
}

}  // namespace darwinop::remote
