#include "apps/calibrate/imu_procedure.hpp"

#include <optional>
#include <ostream>
#include <stdexcept>
#include <string>

#include "apps/calibrate/messages.hpp"

namespace darwinop::calibrate {
namespace {

constexpr Nanos kSettle = std::chrono::milliseconds{500};
constexpr int kMostTries = 3;
// Between two postures are 90 deg; bias and mounting of a sound robot are below 10.
constexpr double kAnotherPostureDeg = 30;

/// The reading as the registers held it. Means transform as samples do: the correction is linear but for a constant.
StillReading uncorrected(StillReading reading, const cm730::ImuCorrection& corrected_by) {
  reading.accel = corrected_by.rawAccelerometer(reading.accel);
  reading.gyro = corrected_by.rawGyro(reading.gyro);
  return reading;
}

std::optional<StillReading> readOnce(runtime::RobotLink& link, Nanos time, const std::atomic<bool>& stop) {
  for (std::uint64_t end = link.sensors().cycle + static_cast<std::uint64_t>(kSettle / link.period()) + 1;
       link.sensors().cycle < end;)
    if (!link.waitForCycle(link.sensors().cycle + 1, stop)) return std::nullopt;
  return readAtRest(link, time, stop);
}

}  // namespace

std::vector<PostureReading> readPostures(runtime::RobotLink& link, Stand& stand,
                                         const cm730::ImuCalibration& corrected_by, Nanos time,
                                         const std::atomic<bool>& stop, std::ostream& log) {
  if (!link.waitForCycle(link.sensors().cycle + 1, stop)) return {};
  if (link.sensors().board.absent) throw std::runtime_error(messages::kNoImu);
  const cm730::ImuCorrection correction{corrected_by};
  std::vector<PostureReading> out;
  for (const TrunkPosture& posture : kPostures) {
    for (int tries = 0; tries < kMostTries; ++tries) {
      const Held held = stand.hold(posture);
      if (held == Held::kEnded) return out;
      if (held == Held::kSkipped) break;
      const auto reading = readOnce(link, time, stop);
      if (!reading && stop) return out;
      if (!reading) throw std::runtime_error(messages::kNoReadings + link.whyEnded());
      const PostureReading raw{&posture, uncorrected(*reading, correction)};
      if (reading->moved) {
        log << posture.name << messages::kMoved << '\n';
      } else if (tiltErrorDeg(raw, {}) > kAnotherPostureDeg) {
        log << posture.name << messages::kAnotherPosture << '\n';
      } else {
        log << posture.name << ": read\n";
        out.push_back(raw);
        break;
      }
    }
  }
  return out;
}

}  // namespace darwinop::calibrate
