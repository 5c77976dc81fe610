// Pictures whose content is known: colour bars with a counter, and a ball on a circle.
#pragma once

#include <cstdint>

#include "hil-mocks/camera/picture.hpp"

namespace darwinop::hil {

/// From the left; at 75 %, as television engineers draw them: nothing is clipped on the way through YUYV.
inline constexpr Colour kBars[] = {{191, 191, 191}, {191, 191, 0}, {0, 191, 191}, {0, 191, 0},
                                   {191, 0, 191},   {191, 0, 0},   {0, 0, 191},   {0, 0, 0}};

/// Bars, and below them the number of the frame: sixteen blocks, white for 1, highest bit at the left.
void drawBars(Picture& picture, std::uint32_t frame);
/// The number that drawBars() left (16 bits), also after the way through a camera.
std::uint32_t frameNumber(const Picture& picture);

inline constexpr double kBallTurn_s = 4;  // once round, clockwise as seen
inline constexpr Colour kBallColour{220, 30, 30}, kLawnColour{40, 110, 50};

struct Ball {
  double x, y, radius;  // pixels from the left and from the top, of the centre
};

/// Its circle is round the middle of the picture, a quarter of the height in radius; at time 0 it is at the right.
Ball ballAt(int width, int height, double seconds);
/// A red ball on a lawn.
void drawBall(Picture& picture, double seconds);

}  // namespace darwinop::hil
