// The published walking algorithm written down as it reads: one sinusoid after the other, doubles, 3x3 matrices, no
// balance. What the gait's engine is compared with; it gives the same ticks.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

namespace darwinop::bench {

class PlainGait {
 public:
  using Ticks = std::array<int, 18>;  // by id minus one

  /// mm, mm, deg, in force from the middle of the next swing.
  void command(double x, double y, double a) { command_x_ = x, command_y_ = y, command_a_ = a; }

  /// The next 8 ms; joints keep their ticks where a leg cannot reach.
  const Ticks& next() {
    const double middle_of_left = kPeriod / 4, middle = kPeriod / 2, middle_of_right = 3 * kPeriod / 4;
    if (near(middle_of_left) || near(middle_of_right)) takeCommand();
    if (near(middle)) t_ = middle;

    const double body_x = sinusoid(t_, kPeriod / 2, kPi, x_ * 0.28, 0);
    const double body_y = sinusoid(t_, kPeriod, 0, 20 + 0.04 * y_offset_, 0);
    const double body_z = sinusoid(t_, kPeriod / 2, 1.5 * kPi, 5, 5);
    const double z_amplitude = 20, z_offset = 10;
    double clock = kLeftUp, begin = kLeftUp, turn = 0;
    if (t_ > kLeftUp && t_ <= kLeftDown) clock = t_;
    if (t_ > kLeftDown && t_ <= kRightUp) clock = kLeftDown;
    if (t_ > kRightUp && t_ <= kRightDown) clock = t_, begin = kRightUp, turn = kPi;
    if (t_ > kRightDown) clock = kRightDown, begin = kRightUp, turn = kPi;
    const double left_clock = std::clamp(t_, kLeftUp, kLeftDown), right_clock = std::clamp(t_, kRightUp, kRightDown);
    const auto move = [&](double amplitude, double offset) {
      return sinusoid(clock, kMove, kPi / 2 + 2 * kPi / kMove * begin + turn, amplitude, offset);
    };
    const double left_x = move(x_, 0), right_x = move(-x_, 0);
    const double left_y = move(y_, y_offset_), right_y = move(-y_, -y_offset_);
    const double left_yaw = move(yaw_, yaw_offset_), right_yaw = move(-yaw_, -yaw_offset_);
    const auto lift = [&](double time, double up, double amplitude, double offset) {
      return sinusoid(time, kLift, kPi / 2 + 2 * kPi / kLift * up, amplitude, offset);
    };
    const double left_z = lift(left_clock, kLeftUp, z_amplitude, z_offset);
    const double right_z = lift(right_clock, kRightUp, z_amplitude, z_offset);
    const double pelvis = 3 * kTicks, standing = 0.35 * pelvis;
    double pelvis_left = 0, pelvis_right = 0;
    if (t_ > kLeftUp && t_ <= kLeftDown) {
      pelvis_left = lift(t_, kLeftUp, standing / 2, standing / 2);
      pelvis_right = lift(t_, kLeftUp, -pelvis / 2, -pelvis / 2);
    } else if (t_ > kRightUp && t_ <= kRightDown) {
      pelvis_left = lift(t_, kRightUp, pelvis / 2, pelvis / 2);
      pelvis_right = lift(t_, kRightUp, -standing / 2, -standing / 2);
    }
    double arm_right = 0, arm_left = 0;
    if (x_ != 0) {
      arm_right = sinusoid(t_, kPeriod, 1.5 * kPi, -x_ * 1.5, 0);
      arm_left = sinusoid(t_, kPeriod, 1.5 * kPi, x_ * 1.5, 0);
    }
    t_ += 8;
    if (t_ >= kPeriod) t_ = 0;

    std::array<double, 6> right{}, left{};
    if (!solve({body_x + right_x - 10, body_y + right_y - 2.5, body_z + right_z + 20}, 0, 0, right_yaw, right) ||
        !solve({body_x + left_x - 10, body_y + left_y + 2.5, body_z + left_z + 20}, 0, 0, left_yaw, left))
      return ticks_;
    constexpr std::array<double, 6> kRightWay{-1, -1, 1, 1, -1, 1}, kLeftWay{-1, -1, -1, -1, 1, 1};
    for (std::size_t i = 0; i < 6; ++i) {
      double right_goal = kRightWay[i] * right[i] * 180 / kPi * kTicks;
      double left_goal = kLeftWay[i] * left[i] * 180 / kPi * kTicks;
      if (i == 1) right_goal += kRightWay[i] * pelvis_right, left_goal += kLeftWay[i] * pelvis_left;
      if (i == 2) right_goal -= kRightWay[i] * 13 * kTicks, left_goal -= kLeftWay[i] * 13 * kTicks;
      set(6 + 2 * i, 0, right_goal);
      set(7 + 2 * i, 0, left_goal);
    }
    set(0, -48.345, arm_right * kTicks);
    set(1, 41.313, -arm_left * kTicks);
    set(2, -17.873, 0);
    set(3, 17.580, 0);
    set(4, 29.300, 0);
    set(5, -29.593, 0);
    return ticks_;
  }

 private:
  using Vector = std::array<double, 3>;
  using Matrix = std::array<Vector, 3>;

  static constexpr double kPi = 3.14159265358979323846, kTicks = 11.378;
  static constexpr double kPeriod = 600, kShare = 0.9;
  static constexpr double kLeftUp = (1 - kShare) * kPeriod / 4, kLeftDown = (1 + kShare) * kPeriod / 4;
  static constexpr double kRightUp = (3 - kShare) * kPeriod / 4, kRightDown = (3 + kShare) * kPeriod / 4;
  static constexpr double kMove = kShare * kPeriod, kLift = kMove / 2;
  static constexpr double kThigh = 93, kCalf = 93, kAnkle = 33.5, kLeg = kThigh + kCalf + kAnkle;

  [[nodiscard]] bool near(double moment) const { return moment - 4 <= t_ && t_ < moment + 4; }
  static double sinusoid(double time, double period, double phase, double amplitude, double offset) {
    return amplitude * std::sin(2 * kPi / period * time - phase) + offset;
  }
  void takeCommand() {
    x_ = command_x_;
    y_ = command_y_ / 2;
    y_offset_ = std::abs(y_);
    yaw_ = command_a_ * kPi / 360;
    yaw_offset_ = std::abs(yaw_);
  }
  void set(std::size_t joint, double rest_deg, double from_rest) {
    ticks_[joint] = std::clamp(static_cast<int>(rest_deg * kTicks) + 2048 + static_cast<int>(from_rest), 0, 4095);
  }

  static Matrix product(const Matrix& a, const Matrix& b) {
    Matrix out{};
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j)
        for (std::size_t k = 0; k < 3; ++k) out[i][j] += a[i][k] * b[k][j];
    return out;
  }
  static Matrix rotation(double roll, double pitch, double yaw) {
    const Matrix x{{{1, 0, 0}, {0, std::cos(roll), -std::sin(roll)}, {0, std::sin(roll), std::cos(roll)}}};
    const Matrix y{{{std::cos(pitch), 0, std::sin(pitch)}, {0, 1, 0}, {-std::sin(pitch), 0, std::cos(pitch)}}};
    const Matrix z{{{std::cos(yaw), -std::sin(yaw), 0}, {std::sin(yaw), std::cos(yaw), 0}, {0, 0, 1}}};
    return product(product(z, y), x);
  }

  static bool solve(const Vector& sole, double roll, double pitch, double yaw, std::array<double, 6>& angles) {
    const Matrix r = rotation(roll, pitch, yaw);
    const Vector p{sole[0], sole[1], sole[2] - kLeg};
    Vector v{}, w{};
    for (std::size_t i = 0; i < 3; ++i) v[i] = p[i] + kAnkle * r[i][2];
    const double reach = std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    const double knee = std::acos((reach * reach - kThigh * kThigh - kCalf * kCalf) / (2 * kThigh * kCalf));
    if (std::isnan(knee)) return false;
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t k = 0; k < 3; ++k) w[i] -= r[k][i] * p[k];
    const double ankle_roll = std::atan2(w[1], w[2] - kAnkle);
    Matrix m = product(r, rotation(-ankle_roll, 0, 0));
    for (std::size_t i = 0; i < 3; ++i) m[i][i] += 1;
    const double hip_yaw = std::atan2(-m[0][1], m[1][1]);
    const double hip_roll = std::atan2(m[2][1], -m[0][1] * std::sin(hip_yaw) + m[1][1] * std::cos(hip_yaw));
    const double theta = std::atan2(m[0][2] * std::cos(hip_yaw) + m[1][2] * std::sin(hip_yaw),
                                    m[0][0] * std::cos(hip_yaw) + m[1][0] * std::sin(hip_yaw));
    const double k = kCalf * std::sin(knee), l = -kThigh - kCalf * std::cos(knee);
    const double forward = std::cos(hip_yaw) * v[0] + std::sin(hip_yaw) * v[1];
    const double up = std::cos(hip_roll) * v[2] + std::sin(hip_yaw) * std::sin(hip_roll) * v[0] -
                      std::cos(hip_yaw) * std::sin(hip_roll) * v[1];
    const double s = (k * up + l * forward) / (k * k + l * l), c = (up - k * s) / l;
    const double hip_pitch = std::atan2(s, c);
    angles = {hip_yaw, hip_roll, hip_pitch, knee, theta - knee - hip_pitch, ankle_roll};
    return true;
  }

  double t_ = 0, x_ = 0, y_ = 0, y_offset_ = 0, yaw_ = 0, yaw_offset_ = 0;
  double command_x_ = 0, command_y_ = 0, command_a_ = 0;
  Ticks ticks_{};
};

}  // namespace darwinop::bench
