#include "connect/lockstep_robot.hpp"

#include <utility>

#include "connect/owned_bus.hpp"
#include "hil-mocks/memory_line.hpp"
#include "hil-mocks/virtual_robot.hpp"

namespace darwinop::connect {
namespace {

/// Line to a virtual robot in memory.
class VirtualLine final : public ByteLine {
 public:
  VirtualLine(const hil::BoardOptions& options, std::unique_ptr<Body> body) : robot_{options, 1, std::move(body)} {}
  [[nodiscard]] Nanos now() noexcept override { return line_.now(); }
  LineStatus write(std::span<const std::uint8_t> bytes) noexcept override { return line_.write(bytes); }
  LineStatus read(std::span<std::uint8_t> into, std::size_t& count, Nanos deadline) noexcept override {
    return line_.read(into, count, deadline);
  }
  void discardInput() noexcept override { line_.discardInput(); }
  [[nodiscard]] std::uint32_t reconnects() const noexcept override { return line_.reconnects(); }
  [[nodiscard]] hil::MemoryLine& memory() noexcept { return line_; }
  [[nodiscard]] Body& body() noexcept { return robot_.body(); }

 private:
  hil::VirtualRobot robot_;
  hil::MemoryLine line_{robot_};
};

/// Captures at each request: the body does not step meanwhile.
class LockstepCamera final : public FrameSource {
 public:
  explicit LockstepCamera(std::unique_ptr<BodyCamera> camera) : camera_{std::move(camera)} {}
  CameraFrame newest() override {
    camera_->look();
    return camera_->newest();
  }
  [[nodiscard]] CameraHealth health() const override { return camera_->health(); }

 private:
  std::unique_ptr<BodyCamera> camera_;
};

/// Clock of the loop: sleeping advances the line's simulated time.
class LineClock final : public runtime::Clock {
 public:
  explicit LineClock(hil::MemoryLine& line) : line_{line} {}
  [[nodiscard]] Nanos now() const noexcept override { return line_.now(); }
  void sleepUntil(Nanos time) noexcept override { line_.advanceTo(time); }

 private:
  hil::MemoryLine& line_;
};

}  // namespace

std::unique_ptr<runtime::RobotLink> lockstepRobot(const runtime::LoopConfig& config, std::unique_ptr<Body> body,
                                                  const Calibration& calibration) {
  hil::BoardOptions options;
  if (body) options.body_step = hil::kPhysicsStep;
  auto line = std::make_unique<VirtualLine>(options, std::move(body));
  auto clock = std::make_unique<LineClock>(line->memory());
  const auto open_camera = [&body_of_robot = line->body()](int width, int height) -> std::unique_ptr<FrameSource> {
    std::unique_ptr<BodyCamera> camera = body_of_robot.openCamera(width, height);
    if (camera == nullptr) return nullptr;
    return std::make_unique<LockstepCamera>(std::move(camera));
  };
  cm730::BusConfig bus_config = cm730::BusConfig::forPeriod(config.period, calibration.offsets);
  bus_config.imu = cm730::ImuCorrection{calibration.imu};
  auto bus = std::make_unique<OwnedBus<VirtualLine>>(std::move(line), bus_config);
  return std::make_unique<runtime::LockstepLink>(config, std::move(bus), std::move(clock), open_camera);
}

}  // namespace darwinop::connect
