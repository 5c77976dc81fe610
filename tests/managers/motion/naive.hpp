// The playback rules written down once more, as the tables of docs/motions.md have them: slow, wide numbers, no state
// machine. What the player has to agree with.
#pragma once

#include <cmath>
#include <vector>

#include "managers/motion/player.hpp"

namespace darwinop::motion::naive {

using Wide = long long;

struct Row {
  int page, step;
  Pose pose;
};

inline Wide floorShift(Wide value, int bits) {
  return static_cast<Wide>(std::floor(static_cast<double>(value) / static_cast<double>(1LL << bits)));
}

struct Servo {
  Wide s = 0, g = 0, d = 0, w = 0, v = 0, a = 0, m = 0, out = 0, speed = 0;
  bool zero = true;

  void put(Wide value) { out = std::max<Wide>(0, std::min<Wide>(4095, value)); }
  void pre(Wide c, Wide n) {
    const Wide delta = (v - w) * c / n;
    if (d != 0) speed = w + delta;
    if (d != 0) a = floorShift((w + floorShift(delta, 1)) * c * 144 / 15, 9);
    put(s + (d != 0 ? a : 0));
  }
  void main(Wide c, Wide n) {
    if (d != 0) speed = v;
    put(d != 0 ? s + m * c / n : s);
  }
  void post(Wide c, Wide n) {
    if (d == 0) return put(s);
    if (c == n - 1) return put(g);
    if (!zero) return main(c, n);
    const Wide delta = -w * c / n;
    speed = w + delta;
    put(s + floorShift((w + floorShift(delta, 1)) * c * 144 / 15, 9));
  }
};

/// All ticks of a chain, or the first `most` of them. `stop_at`: the tick before which a stop is requested, or -1.
inline std::vector<Row> play(const PageFile& pages, int start, const Pose& present, std::size_t most, int stop_at) {
  std::vector<Row> rows;
  std::array<Servo, kJoints> servos;
  for (std::size_t j = 0; j < kJoints; ++j) servos[j].s = servos[j].g = servos[j].out = present[j];
  bool stopping = false;
  int number = start, index = 0;
  const auto record = [&] {
    Row row{number, index, {}};
    for (std::size_t j = 0; j < kJoints; ++j) row.pose[j] = static_cast<int>(servos[j].out);
    rows.push_back(row);
  };
  const auto page = [&pages](int i) -> const Page& { return pages[static_cast<std::size_t>(i)]; };

  int left = page(start).repeat, follower = 0;
  while (rows.size() < most) {
    const Page& now = page(number);
    const Step& step = now.step[static_cast<std::size_t>(index)];
    const bool last = index + 1 == now.steps;
    stopping = stopping || (stop_at >= 0 && rows.size() >= static_cast<std::size_t>(stop_at));
    if (last) {
      follower = stopping ? now.exit : left > 1 ? number : now.next;
      if (page(follower).steps == 0 || page(follower).repeat == 0) follower = 0;
    }
    const Step* next = last ? (follower != 0 ? &page(follower).step[0] : nullptr) : &step + 1;
    const Wide pause = step.pause * 32 / now.speed, value = std::max(1, step.time * now.speed / 32);
    Wide farthest = 0;
    for (std::size_t j = 0; j < kJoints; ++j) {
      Servo& servo = servos[j];
      servo.s = servo.g;
      if ((step.position[j + 1] & 0x4000) == 0) servo.g = step.position[j + 1];
      servo.d = servo.g - servo.s;
      farthest = std::max(farthest, std::abs(servo.d));
      const Wide then = next && (next->position[j + 1] & 0x4000) == 0 ? next->position[j + 1] : servo.g;
      const bool same = (servo.s < servo.g && servo.g < then) || (servo.s > servo.g && servo.g > then);
      servo.zero = !same || pause > 0;
      servo.a = 0;
    }
    Wide n = now.schedule == 0 ? 40 * farthest / (3 * value) : value, accel = now.acceleration;
    if (n <= 2 * accel) {
      accel = n == 0 ? 0 : (n - 1) / 2;
      if (accel == 0) n = 0;
    }
    for (Servo& servo : servos) {
      const Wide wanted = 2560 * servo.d / 12 - servo.w * 2 * accel;
      const Wide by = std::max<Wide>(1, servo.zero ? 4 * (n - accel) : 2 * accel + 4 * (n - accel));
      servo.v = std::max<Wide>(-1023, std::min<Wide>(1023, wanted / by));
    }
    record();
    for (Wide c = 1; c <= accel; ++c) {
      for (Servo& servo : servos) servo.pre(c, accel);
      record();
    }
    record();
    for (Servo& servo : servos) {
      servo.s = servo.out;
      servo.w = servo.speed;
      if (servo.zero)
        servo.m = servo.d - servo.a - floorShift(servo.v * accel * 12 / 5, 8);
      else
        servo.m = n == accel ? 0 : (servo.d - servo.a) * (n - 2 * accel) / (n - accel);
    }
    for (Wide c = 1; c <= n - 2 * accel; ++c) {
      for (Servo& servo : servos) servo.main(c, n - 2 * accel);
      record();
    }
    record();
    for (Servo& servo : servos) {
      servo.s = servo.out;
      servo.w = servo.speed;
      servo.m = servo.d - servo.m - servo.a;
    }
    for (Wide c = 1; c <= accel; ++c) {
      for (Servo& servo : servos) servo.post(c, accel);
      record();
    }
    for (Servo& servo : servos) servo.w = servo.speed;
    if (pause > 0) {
      for (Wide c = 0; c <= pause; ++c) record();
      for (Servo& servo : servos) servo.w = servo.speed = 0;
    }
    if (last && follower == 0) break;
    if (!last) {
      ++index;
      continue;
    }
    left = follower == number && left > 1 ? left - 1 : page(follower).repeat;
    number = follower;
    index = 0;
  }
  if (rows.size() > most) rows.resize(most);
  return rows;
}

}  // namespace darwinop::motion::naive
