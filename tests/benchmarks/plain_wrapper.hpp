// The peer: the straightforward way to do a cycle's work, as wrappers of this robot have done it since 2013 (written
// again from its described behaviour). One buffer for everything, every gain and limit sent in every cycle, a whole
// reply parsed at its end with the rest shifted down frame by frame, values kept as raw bytes. No safety layer, no
// ages, no isolation of silent servos, no statistics, nothing shared with another thread.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace darwinop::bench {

class PlainWrapper {
 public:
  /// `goals_only`: two bytes a servo instead of eight, as 30 servos need to fit a frame.
  explicit PlainWrapper(int servos, bool goals_only = false) : servos_{servos}, goals_only_{goals_only} {}

  void setGoal(int servo, double rad) {
    goal_[static_cast<std::size_t>(servo)] = static_cast<int>(rad * 180 / M_PI * 11.378) + 2048;
  }

  /// The sync write and the bulk request; returns the bytes to send.
  std::size_t encode() {
    const int data = goals_only_ ? 2 : 8;
    std::size_t n = begin(sync_, 0x83, servos_ * (data + 1) + 4);
    sync_[n++] = goals_only_ ? 30 : 28;
    sync_[n++] = static_cast<std::uint8_t>(data);
    for (int i = 0; i < servos_; ++i) {
      const int goal = goal_[static_cast<std::size_t>(i)];
      const auto low = static_cast<std::uint8_t>(goal & 255), high = static_cast<std::uint8_t>(goal >> 8);
      sync_[n++] = static_cast<std::uint8_t>(i + 1);
      const std::uint8_t full[8] = {32, 0, low, high, 255, 3, 255, 3};
      const std::uint8_t* from = goals_only_ ? full + 2 : full;
      for (int k = 0; k < data; ++k) sync_[n++] = from[k];
    }
    n = finish(sync_, n);
    std::size_t m = begin(bulk_, 0x92, 3 * (servos_ + 1) + 3);
    bulk_[m++] = 0;
    addRequest(m, 30, 200, 24);
    for (int i = 0; i < servos_; ++i) addRequest(m, 6, i + 1, 36);
    return n + finish(bulk_, m);
  }

  /// All bytes of a reply; returns how many devices were found in it.
  int decode(const std::uint8_t* bytes, std::size_t count) {
    std::vector<std::uint8_t> rest(bytes, bytes + count);
    int found = 0;
    while (rest.size() > 6) {
      std::size_t start = 0;
      while (start + 1 < rest.size() && (rest[start] != 0xFF || rest[start + 1] != 0xFF)) ++start;
      rest.erase(rest.begin(), rest.begin() + static_cast<std::ptrdiff_t>(start));
      if (rest.size() < 6 || rest.size() < rest[3] + 4u) break;
      const std::size_t size = rest[3] + 4u;
      std::uint8_t sum = 0;
      for (std::size_t i = 2; i + 1 < size; ++i) sum = static_cast<std::uint8_t>(sum + rest[i]);
      if (static_cast<std::uint8_t>(~sum) == rest[size - 1]) {
        const int id = rest[2], start_address = id == 200 ? 24 : 36;
        for (std::size_t i = 0; i + 6 < size; ++i)
          table_[static_cast<std::size_t>(id)][static_cast<std::size_t>(start_address) + i] = rest[5 + i];
        ++found;
        rest.erase(rest.begin(), rest.begin() + static_cast<std::ptrdiff_t>(size));
      } else {
        rest.erase(rest.begin(), rest.begin() + 2);
      }
    }
    return found;
  }

  /// What a controller reads: position, speed, load of each servo, gyro and accelerometer.
  double sum() const {
    double total = 0;
    for (int i = 1; i <= servos_; ++i) {
      total += (word(i, 36) - 2048) * 0.088 * M_PI / 180;
      total += word(i, 38) * 0.114 * M_PI / 30;
      total += word(i, 40) * 2.5 / 1023;
    }
    for (int address = 38; address < 50; address += 2) total += word(200, address);
    return total;
  }

 private:
  int word(int id, int address) const {
    const auto& table = table_[static_cast<std::size_t>(id)];
    return table[static_cast<std::size_t>(address)] | table[static_cast<std::size_t>(address) + 1] << 8;
  }
  static std::size_t begin(std::array<std::uint8_t, 300>& frame, int instruction, int length) {
    frame[0] = frame[1] = 0xFF;
    frame[2] = 0xFE;
    frame[3] = static_cast<std::uint8_t>(length);
    frame[4] = static_cast<std::uint8_t>(instruction);
    return 5;
  }
  void addRequest(std::size_t& n, int count, int id, int address) {
    bulk_[n++] = static_cast<std::uint8_t>(count);
    bulk_[n++] = static_cast<std::uint8_t>(id);
    bulk_[n++] = static_cast<std::uint8_t>(address);
  }
  static std::size_t finish(std::array<std::uint8_t, 300>& frame, std::size_t n) {
    std::uint8_t sum = 0;
    for (std::size_t i = 2; i < n; ++i) sum = static_cast<std::uint8_t>(sum + frame[i]);
    frame[n] = static_cast<std::uint8_t>(~sum);
    return n + 1;
  }

  int servos_;
  bool goals_only_;
  std::array<int, 32> goal_{};
  std::array<std::uint8_t, 300> sync_{}, bulk_{};
  std::array<std::array<std::uint8_t, 128>, 256> table_{};
};

}  // namespace darwinop::bench
