#include "hil-mocks/camera/test_pattern.hpp"

#include <cmath>
#include <numbers>

namespace darwinop::hil {
namespace {

constexpr int kBarCount = sizeof kBars / sizeof kBars[0];
constexpr int kBits = 16;
constexpr int kCounterShare = 8;  // share of the height
constexpr Colour kWhite{235, 235, 235}, kBlack{16, 16, 16};
constexpr double kRadiusShare = 0.08;  // of the height; a 10 cm ball at half a metre

int counterTop(const PaintedPicture& picture) {
  return picture.height - picture.height / kCounterShare;
}

}  // namespace

void drawBars(PaintedPicture& picture, std::uint32_t frame) {
  const int top = counterTop(picture);
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x) {
      const bool one = (frame >> (kBits - 1 - x * kBits / picture.width) & 1) != 0;
      picture.set(x, y, y < top ? kBars[x * kBarCount / picture.width] : one ? kWhite : kBlack);
    }
}

std::uint32_t frameNumber(const PaintedPicture& picture) {
  const int y = (counterTop(picture) + picture.height) / 2;
  std::uint32_t number = 0;
  for (int bit = 0; bit < kBits; ++bit) {
    const Colour colour = picture.colour((2 * bit + 1) * picture.width / (2 * kBits), y);
    number = number << 1 | (colour[1] > 128 ? 1u : 0u);
  }
  return number;
}

PaintedBall ballAt(int width, int height, double seconds) {
  const double angle = 2 * std::numbers::pi * seconds / kBallTurnS, circle = height / 4.0;
  return {width / 2.0 + circle * std::cos(angle), height / 2.0 + circle * std::sin(angle), kRadiusShare * height};
}

void drawBall(PaintedPicture& picture, double seconds) {
  const PaintedBall ball = ballAt(picture.width, picture.height, seconds);
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x) {
      const double dx = x + 0.5 - ball.x, dy = y + 0.5 - ball.y;
      picture.set(x, y, dx * dx + dy * dy <= ball.radius * ball.radius ? kBallColour : kLawnColour);
    }
}

}  // namespace darwinop::hil
