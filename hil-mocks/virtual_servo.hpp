// One MX-28 on the virtual bus: its registers, its power, its protections.
#pragma once

#include <cstdint>
#include <optional>

#include "core/conversions.hpp"
#include "core/registers.hpp"
#include "hal/body.hpp"
#include "hil-mocks/device.hpp"
#include "hil-mocks/servo_observer.hpp"

namespace darwinop::hil {

/// How a servo comes to the robot. Default: as the robot's own set-up tool leaves it.
struct ServoOptions {
  std::uint8_t id = 0;  // 0: the joint's own
  std::uint8_t firmware = 36, return_delay = 0, status_level = 2;
  std::uint8_t baud = 1;  // the bus runs at 1 Mbaud; another value makes the servo unreachable
  bool missing = false;
  std::uint16_t model = find(kMx28, "model").reset;
  // Registers 6, 8 and 14. Both limits 0: wheel mode; both 4095: multi-turn mode.
  std::uint16_t cw_limit = 0, ccw_limit = kTickMax, max_torque = 1023;

  /// A replaced servo that nobody has set up. `baud` 1: somebody got as far as that.
  static constexpr ServoOptions factoryFresh(std::uint8_t baud_register = 34) {
    return {1, 36, 250, 2, baud_register, false};
  }
};

class VirtualServo : public Device {
 public:
  VirtualServo(Joint joint, const ServoOptions& options);

  /// Supply of the bus switched at `now`; hears nothing until `boot` later. RAM starts from its reset values.
  void powerUp(Nanos now, Nanos boot);
  void powerDown();
  [[nodiscard]] bool listens(Nanos now) const { return powered_ && now >= awake_at_ && table_.byte(kBaudAddress) == 1; }

  // -- what a fault does to it
  /// Its plug is out: no supply either. Back in, it starts from its reset values with the next powerUp().
  void setDead(bool dead) {
    dead_ = dead;
    if (dead) powerDown();
  }
  /// Its joint is stuck: it trips by overload after so long under torque, each time again. Nothing: it is free.
  void setJam(std::optional<Nanos> trips_after);
  /// So much time goes by, for what a jam does.
  void strain(Nanos dt);
  void setErrors(std::uint8_t bits) { injected_errors_ = bits; }
  /// Whatever the body says of it; nothing: as the body says.
  void setTemperature(std::optional<double> celsius) { forced_temperature_c_ = celsius; }
  /// What the bus supplies. How much of it reaches the servo is for the body to say.
  void setSupply(double volt) { supply_v_ = volt; }
  /// Where the body does not say.
  void setUsualTemperature(double celsius) { usual_temperature_c_ = celsius; }

  /// What its motor is told.
  [[nodiscard]] ServoState state() const;
  /// Null: nobody.
  void observe(ServoObserver* observer) { observer_ = observer; }

  /// Brings the measuring registers up to date.
  void measure(const JointMotion& motion);
  /// What the motor is told in that motion, after the servo's own protections had their say.
  [[nodiscard]] const ServoDrive& drive(const JointMotion& motion);

 private:
  static constexpr std::uint8_t kBaudAddress = find(kMx28, "baud").address;
  static std::uint8_t rounded(double value);

  [[nodiscard]] std::uint8_t standingErrors() const override;
  [[nodiscard]] std::uint8_t objections(std::uint8_t address, Bytes data) const override;
  void write(std::uint8_t address, Bytes data) override;
  void noteRefusal(std::uint8_t errors) override;
  void factoryReset() override;
  void showRegistered(bool waiting) override;
  [[nodiscard]] bool wheelMode() const;
  [[nodiscard]] bool multiTurnMode() const;
  [[nodiscard]] std::uint16_t positionRegister(double position_rad) const;
  [[nodiscard]] bool goalWithinLimits(std::uint16_t goal) const;
  void feel(const JointMotion& motion);
  void updateDrive();

  Joint joint_;
  ServoObserver* observer_ = nullptr;
  bool missing_, dead_ = false, powered_ = false;
  bool goal_refused_ = false, overloaded_ = false;
  std::uint8_t injected_errors_ = 0;
  double supply_v_ = 0, usual_temperature_c_ = 25;
  std::optional<double> forced_temperature_c_;
  std::optional<Nanos> trips_after_;
  Nanos strained_for_{0};
  bool strain_trips_ = false;
  Nanos awake_at_{0};
  std::uint16_t position_;  // ticks; survives power-off as the horn does
  ServoDrive drive_;
};

}  // namespace darwinop::hil
