// Test pictures: colour bars with a frame counter, and a ball on a circle.
#pragma once

#include <cstdint>

#include "hil-mocks/camera/picture.hpp"

namespace darwinop::hil {

/// Left to right, at 75 % (as in television test patterns), so that YUYV does not clip.
inline constexpr Colour kBars[] = {{191, 191, 191}, {191, 191, 0}, {0, 191, 191}, {0, 191, 0},
                                   {191, 0, 191},   {191, 0, 0},   {0, 0, 191},   {0, 0, 0}};

/// Bars, and below them the frame number: sixteen blocks, white for 1, most significant bit left.
void drawBars(PaintedPicture& picture, std::uint32_t frame);
/// Decodes the number drawn by drawBars() (16 bits), also from a captured picture.
std::uint32_t frameNumber(const PaintedPicture& picture);

inline constexpr double kBallTurnS = 4;  // one clockwise turn
inline constexpr Colour kBallColour{230, 110, 25}, kLawnColour{40, 110, 50};

struct PaintedBall {
  double x, y, radius;  // pixels from the left and from the top, of the centre
};

/// Circle around the centre with a radius of a quarter of the height; at time 0 the ball is at the right.
PaintedBall ballAt(int width, int height, double seconds);
/// An orange ball on green.
void drawBall(PaintedPicture& picture, double seconds);

}  // namespace darwinop::hil
