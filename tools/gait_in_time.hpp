// Pictures of a gait over time: where the soles are in a period, and when they are on the floor.
#pragma once

#include <initializer_list>
#include <string>
#include <tuple>

#include "gait_colours.hpp"
#include "managers/gait/stride.hpp"
#include "svg.hpp"

namespace darwinop::pictures {

using namespace gait;
using svg::number;
using svg::Picture;
using svg::Points;

/// A panel with time from left to right.
struct Panel {
  Picture& picture;
  double left, top, width, height, low, high, period;

  [[nodiscard]] double x(double ms) const { return left + width * ms / period; }
  [[nodiscard]] double y(double value) const { return top + height * (high - value) / (high - low); }
  void frame(const std::string& what, std::initializer_list<double> marks) const {
    picture.words(left, top - 6, what);
    for (const double mark : marks) {
      picture.curve({{left, y(mark)}, {left + width, y(mark)}}, "#ccc", 0.7);
      picture.words(left - 6, y(mark) + 4, std::to_string(static_cast<int>(mark)), "end", kGrey);
    }
  }
  void bothFeetDown(const Timing& t) const {
    for (const auto& [from, to] : {std::pair{0.0, t.left_up}, {t.left_down, t.right_up}, {t.right_down, t.period}})
      picture.box(x(from), top, x(to) - x(from), height, kBand);
  }
  template <class At>
  void draw(At&& at, const char* colour) const {
    Points points;
    for (double ms = 0; ms <= period; ms += 5) points.emplace_back(x(ms), y(at(ms)));
    picture.curve(points, colour);
  }
};

/// Where both soles are in a period of walking straight on, seen from the hips.
inline std::string period() {
  Picture picture{760, 560};
  const Parameters p;
  const Timing timing{p};
  const Stride stride{{1, 0, 0, false}, p};
  const auto feet = [&](double ms) { return feetAt(ms, timing, stride, p); };
  picture.words(70, 22, "One period at X = 1: the soles as seen from the hips, mm.", "start", "#000");
  picture.words(480, 22, "left foot", "start", kLeft);
  picture.words(550, 22, "right foot", "start", kRight);
  picture.words(625, 22, "grey: both down", "start", kGrey);
  const Panel x{picture, 70, 60, 620, 120, -40, 20, 600}, y{picture, 70, 220, 620, 120, -30, 30, 600},
      z{picture, 70, 380, 620, 120, 0, 60, 600};
  for (const Panel& panel : {x, y, z}) panel.bothFeetDown(timing);
  x.frame("x, forwards", {-40, -20, 0, 20});
  y.frame("y, to the left", {-30, 0, 30});
  z.frame("z, up from the stretched leg", {0, 20, 40, 60});
  x.draw([&](double ms) { return feet(ms).left.x; }, kLeft);
  x.draw([&](double ms) { return feet(ms).right.x; }, kRight);
  y.draw([&](double ms) { return feet(ms).left.y; }, kLeft);
  y.draw([&](double ms) { return feet(ms).right.y; }, kRight);
  z.draw([&](double ms) { return feet(ms).left.z; }, kLeft);
  z.draw([&](double ms) { return feet(ms).right.z; }, kRight);
  picture.arrow(z.x(150), z.y(feet(150).right.z), z.x(150), z.y(feet(150).left.z), true);
  picture.words(z.x(150) + 6, z.y(22), "foot_height");
  picture.arrow(y.x(450), y.y(p.y_offset / 2), y.x(450), y.y(feet(450).left.y), true);
  picture.words(y.x(450) + 6, y.y(5), "swing_right_left");
  picture.arrow(x.x(300), x.y(feet(300).right.x), x.x(300), x.y(feet(300).left.x), true);
  picture.words(x.x(300) + 8, x.y(13), "2 x 20 mm x X");
  picture.curve({{x.left, x.y(p.x_offset)}, {x.left + x.width, x.y(p.x_offset)}}, "#333", 0.7,
                "stroke-dasharray=\"4 3\"");
  picture.words(x.left + x.width + 4, x.y(p.x_offset) + 4, "x_offset");
  for (int ms = 0; ms <= 600; ms += 100)
    picture.words(z.x(ms), z.top + z.height + 18, std::to_string(ms), "middle", kGrey);
  picture.words(z.x(300), z.top + z.height + 36, "ms: period_time is 600", "middle", kGrey);
  return picture.text();
}

inline std::string doubleSupport() {
  Picture picture{760, 330};
  double top = 50;
  for (const double ratio : {0.1, 0.5}) {
    Parameters p;
    p.dsp_ratio = ratio;
    p.swing_top_down = 0;
    const Timing timing{p};
    const Stride stride{{}, p};
    const Panel lift{picture, 150, top, 540, 80, 0, 45, 600};
    lift.bothFeetDown(timing);
    lift.frame("dsp_ratio = " + number(ratio), {0, 40});
    const auto floor = feetAt(0, timing, stride, p).left.z;
    lift.draw([&](double ms) { return feetAt(ms, timing, stride, p).left.z - floor; }, kLeft);
    lift.draw([&](double ms) { return feetAt(ms, timing, stride, p).right.z - floor; }, kRight);
    for (const auto& [row, up, down, colour, name] :
         {std::tuple{0, timing.left_up, timing.left_down, kLeft, "left on the floor"},
          {1, timing.right_up, timing.right_down, kRight, "right on the floor"}}) {
      const double y = top + 92 + 16 * row;
      picture.words(142, y + 9, name, "end", colour);
      picture.box(lift.x(0), y, lift.x(up) - lift.x(0), 10, colour);
      picture.box(lift.x(down), y, lift.x(600) - lift.x(down), 10, colour);
    }
    top += 145;
  }
  picture.words(150, 22, "Height of the soles above the floor, mm, in one period of 600 ms. Grey: both feet down.",
                "start", "#000");
  return picture.text();
}

}  // namespace darwinop::pictures
