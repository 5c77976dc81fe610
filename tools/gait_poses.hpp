// Pictures of a robot: its feet from above, its legs from the side.
#pragma once

#include <cmath>
#include <string>

#include "core/units.hpp"
#include "gait_colours.hpp"
#include "managers/gait/leg.hpp"
#include "svg.hpp"

namespace darwinop::pictures {

using namespace gait;
using svg::Picture;
using svg::Points;

inline constexpr double kHipHalf = 37;  // mm from the middle of the trunk to a hip

/// From above: where the feet are when both are down, after the left one's swing and after the right one's.
inline void footprints(Picture& picture, double middle, const WalkCommand& command, const std::string& title,
                       const std::string& below) {
  Parameters p;
  const Timing timing{p};
  const Stride stride{command, p};
  constexpr double kZoom = 0.9, kTop = 150, kHalfLength = 48, kHalfWidth = 26;  // px a mm; px; mm
  const auto foot = [&](const Foot& f, double hip, const char* colour, bool now) {
    Points outline;
    for (const auto& [along, aside] : {std::pair{kHalfLength, kHalfWidth},
                                       {kHalfLength, -kHalfWidth},
                                       {-kHalfLength, -kHalfWidth},
                                       {-kHalfLength, kHalfWidth}}) {
      const double forward = f.x + along * std::cos(f.yaw) - aside * std::sin(f.yaw);
      const double left = hip + f.y + along * std::sin(f.yaw) + aside * std::cos(f.yaw);
      outline.emplace_back(middle - kZoom * left, kTop - kZoom * forward);
    }
    picture.closed(outline, colour, now ? colour : "none",
                   now ? "fill-opacity=\"0.25\" stroke-width=\"2\"" : "stroke-dasharray=\"5 4\"");
  };
  const Feet before = feetAt(0, timing, stride, p), after = feetAt(timing.left_down, timing, stride, p);
  foot(before.left, kHipHalf, kLeft, false);
  foot(before.right, -kHipHalf, kRight, false);
  foot(after.left, kHipHalf, kLeft, true);
  foot(after.right, -kHipHalf, kRight, true);
  picture.dot(middle, kTop, 3, "#333");
  picture.words(middle, 24, title, "middle", "#000");
  picture.words(middle, 262, below, "middle", "#333");
}

inline std::string amplitudes() {
  Picture picture{760, 300};
  footprints(picture, 130, {1, 0, 0, false}, "X = 1: forwards", "2 x 20 mm apart, then the other way");
  footprints(picture, 380, {0, 1, 0, false}, "Y = 1: to the left", "open by 2 x 40 mm, then close");
  footprints(picture, 630, {0, 0, 0.5, false}, "A = 0.5: turn to the left", "open by 2 x 25 degrees, then close");
  picture.words(380, 286,
                "From above, forwards is up. Dashed: when the right foot has come down; filled: the left. Dot: middle "
                "of the trunk.",
                "middle", kGrey);
  return picture.text();
}

/// From the right side, the leg that the engine asks for: the sole stays where it is, only the trunk leans.
inline void figure(Picture& picture, double middle, const Parameters& p, const std::string& title) {
  constexpr double kZoom = 0.8, kFloor = 320, kThigh = 93, kCalf = 93, kTrunk = 122;
  const Timing timing{p};
  const Stride stride{{}, p};
  const Foot sole = feetAt(0, timing, stride, p).right;
  const Leg leg = *legFor(sole, Ik::kExact);
  const double hip_x = -sole.x, hip_z = 219.5 - sole.z;
  const auto at = [&](double x, double z) { return std::pair{middle + kZoom * x, kFloor - kZoom * z}; };
  const double knee_x = hip_x - kThigh * std::sin(leg.hip_pitch), knee_z = hip_z - kThigh * std::cos(leg.hip_pitch);
  const double calf = leg.hip_pitch + leg.knee;
  const double ankle_x = knee_x - kCalf * std::sin(calf), ankle_z = knee_z - kCalf * std::cos(calf);
  const double lean = p.hip_pitch_offset * kRadPerDegree;
  const auto hip = at(hip_x, hip_z);
  const auto chest = at(hip_x + kTrunk * std::sin(lean), hip_z + kTrunk * std::cos(lean));
  picture.curve({{middle - 90, kFloor}, {middle + 90, kFloor}}, kGrey, 1);
  picture.curve({at(ankle_x - 52, 3), at(ankle_x + 52, 3)}, kRight, 6);
  picture.curve({at(ankle_x, 3), at(ankle_x, ankle_z), at(knee_x, knee_z), hip}, kRight, 6);
  picture.curve({hip, at(hip_x, hip_z + kTrunk)}, kGrey, 1, "stroke-dasharray=\"4 3\"");
  picture.curve({hip, chest}, "#333", 14);
  picture.dot(chest.first + 22 * std::sin(lean), chest.second - 22 * std::cos(lean), 15, "#333");
  for (const auto& [x, y] : {at(ankle_x, ankle_z), at(knee_x, knee_z), hip}) picture.dot(x, y, 4, "#fff");
  picture.words(middle, 346, title, "middle");
}

inline std::string posture() {
  Picture picture{930, 360};
  double middle = 90;
  for (const double lean : {0, 13, 30}) {
    Parameters p;
    p.hip_pitch_offset = lean;
    figure(picture, middle, p, "hip_pitch_offset = " + std::to_string(static_cast<int>(lean)));
    middle += 150;
  }
  for (const double crouch : {5, 20, 60}) {
    Parameters p;
    p.z_offset = crouch;
    figure(picture, middle, p, "z_offset = " + std::to_string(static_cast<int>(crouch)));
    middle += 150;
  }
  picture.words(20, 22, "The stance, from the right: forwards is right. Degrees; mm.", "start", "#000");
  return picture.text();
}

}  // namespace darwinop::pictures
