// One MX-28, MX-64 or MX-106 on the virtual bus: registers, power, protections.
#pragma once

#include <cstdint>
#include <optional>

#include "core/conversions.hpp"
#include "core/registers.hpp"
#include "core/servo_models.hpp"
#include "hal/body.hpp"
#include "hil-mocks/device.hpp"
#include "hil-mocks/servo_observer.hpp"

namespace darwinop::hil {

/// Initial configuration of a servo. Default: as set by the robot's own set-up tool.
struct ServoOptions {
  std::uint8_t id = 0;  // 0: the joint's id
  std::uint8_t firmware = 36, return_delay = 0, status_level = 2;
  std::uint8_t baud = 1;  // the bus runs at 1 Mbaud; with another value the servo is unreachable
  bool missing = false;
  bool keeps_torque = false;   // once on, torque ends with the supply only: a defect, or writes that do not arrive
  bool torque_by_goal = true;  // a goal write switches torque on, as in an MX-28; false: its switch only
  std::uint16_t model = find(kMx28, "model").reset;
  std::uint8_t drive_mode = 0;  // register 10; an MX-28 has none
  bool torque_control = false;  // register 70 after the first power-up; an MX-28 has none
  // Registers 6, 8 and 14. Both limits 0: wheel mode; both 4095: multi-turn mode.
  std::uint16_t cw_limit = 0, ccw_limit = kTickMax, max_torque = 1023;

  /// A new servo with factory settings. `baud` 1: only the baud rate has been set.
  static constexpr ServoOptions factoryFresh(std::uint8_t baud_register = 34) {
    return {1, 36, 250, 2, baud_register, false};
  }
};

class VirtualServo : public BusDevice {
 public:
  VirtualServo(Joint joint, const ServoOptions& options);

  /// Bus supply on at `now`; receives nothing until `boot` later. RAM starts from its reset values.
  void powerUp(Nanos now, Nanos boot);
  void powerDown();
  [[nodiscard]] bool listens(Nanos now) const { return powered_ && now >= awake_at_ && table_.byte(kBaudAddress) == 1; }

  // -- faults
  /// Disconnected, also from the supply. Reconnected, it starts from its reset values at the next powerUp().
  void setDead(bool dead) {
    dead_ = dead;
    if (dead) powerDown();
  }
  /// Blocked joint: trips by overload after this time under torque, repeatedly. Empty: not blocked.
  void setJam(std::optional<Nanos> trips_after);
  /// Advances the time of a jam.
  void strain(Nanos dt);
  void setErrors(std::uint8_t bits) { injected_errors_ = bits; }
  /// Overrides the body's value; empty: the body's.
  void setTemperature(std::optional<double> celsius) { forced_temperature_c_ = celsius; }
  /// Supply of the bus. The body determines how much of it reaches the servo.
  void setSupply(double volt) { supply_v_ = volt; }
  /// Used if the body does not specify it.
  void setUsualTemperature(double celsius) { usual_temperature_c_ = celsius; }

  /// Motor command.
  [[nodiscard]] ServoState state() const;
  /// May be null.
  void observe(ServoObserver* observer) { observer_ = observer; }

  /// Updates the measurement registers.
  void measure(const JointMotion& motion);
  /// Motor command for that motion, limited by the servo's protections.
  [[nodiscard]] const ServoDrive& drive(const JointMotion& motion);

 private:
  static constexpr std::uint8_t kBaudAddress = find(kMx28, "baud").address;
  static constexpr std::uint16_t kClockwise = 1024;  // bit 10 of the speed register, in wheel mode only
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
  /// Stall torque relative to an MX-28. Bodies have the motor of an MX-28: a stronger servo moves them as long as it
  /// needs no more than that.
  const double strength_;
  const bool keeps_torque_, torque_by_goal_;
  bool missing_, torque_control_;
  bool dead_ = false, powered_ = false;
  bool goal_refused_ = false, overloaded_ = false;
  std::uint8_t injected_errors_ = 0;
  double supply_v_ = 0, usual_temperature_c_ = 25;
  std::optional<double> forced_temperature_c_;
  std::optional<Nanos> trips_after_;
  Nanos strained_for_{0};
  bool strain_trips_ = false;
  Nanos awake_at_{0};
  std::uint16_t position_;  // ticks; survives power-off, as the horn position does
  ServoDrive drive_;
};

}  // namespace darwinop::hil
