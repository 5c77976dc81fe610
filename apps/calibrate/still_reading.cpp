#include "apps/calibrate/still_reading.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/registers.hpp"

namespace darwinop::calibrate {
namespace {

constexpr Register kGyro = find(kCm730, "gyro_x"), kAccelerometer = find(kCm730, "accel_x");  // all axes have its scale

// A hand that trembles turns the trunk by 0.1 to 0.3 rad/s; a robot that lies does not exceed the noise of its
// gyroscope, about one step of the register (0.06 rad/s).
constexpr double kMovingRadS = 4 * kGyro.scale;
constexpr double kShakingMs2 = 8 * kAccelerometer.scale;  // 0.6 m/s2, as the servos' own vibration

double greatestDeviation(std::span<const double> samples, double mean) {
  double most = 0;
  for (const double value : samples) most = std::max(most, std::abs(value - mean));
  return most;
}

}  // namespace

void meanOf(std::span<const double> samples, double step, double& mean, double& sigma) {
  constexpr std::size_t kParts = 10;
  const auto average = [](std::span<const double> some) {
    double sum = 0;
    for (const double value : some) sum += value;
    return sum / static_cast<double>(some.size());
  };
  mean = average(samples);
  double variance = 0, parts = 0;
  for (const double value : samples) variance += (value - mean) * (value - mean) / static_cast<double>(samples.size());
  const std::size_t length = std::max<std::size_t>(1, samples.size() / kParts);
  double between = 0;
  for (std::size_t at = 0; at + length <= samples.size(); at += length) {
    const double part = average(samples.subspan(at, length));
    between += (part - mean) * (part - mean);
    ++parts;
  }
  sigma = std::sqrt(
      std::max(between / std::max(1.0, parts - 1), variance * parts / static_cast<double>(samples.size())) / parts);
  if (std::sqrt(variance) < step / 4) sigma = std::hypot(sigma, step / std::sqrt(12.0));
}

std::optional<StillReading> readAtRest(runtime::RobotLink& link, Nanos time, const std::atomic<bool>& stop) {
  std::array<std::vector<double>, 3> gyro, accel;
  const auto cycles = static_cast<std::uint64_t>(time / link.period());
  const std::uint64_t first = link.sensors().cycle + 1;
  for (std::uint64_t cycle = first; cycle < first + cycles; ++cycle) {
    if (!link.waitForCycle(cycle, stop)) return std::nullopt;
    const Sensors seen = link.sensors();
    if (!seen.board.motion.fresh()) continue;
    for (std::size_t i = 0; i < 3; ++i) {
      gyro[i].push_back(seen.board.gyro[i].value);
      accel[i].push_back(seen.board.accelerometer[i].value);
    }
  }
  if (gyro[0].size() < std::max<std::uint64_t>(2, cycles / 2)) return std::nullopt;
  StillReading out{.samples = gyro[0].size()};
  for (std::size_t i = 0; i < 3; ++i) {
    meanOf(gyro[i], kGyro.scale, out.gyro[i], out.gyro_sigma[i]);
    meanOf(accel[i], kAccelerometer.scale, out.accel[i], out.accel_sigma[i]);
    out.moved = out.moved || greatestDeviation(gyro[i], out.gyro[i]) > kMovingRadS ||
                greatestDeviation(accel[i], out.accel[i]) > kShakingMs2;
  }
  return out;
}

}  // namespace darwinop::calibrate
