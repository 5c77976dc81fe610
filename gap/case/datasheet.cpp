// What the maker of a servo says, in two forms: as the numbers of a baseline, or as figures at some voltage.
#include <charconv>

#include "core/units.hpp"
#include "experiments/logs/header.hpp"
#include "gap/case/baseline_keys.hpp"
#include "gap/case/messages.hpp"
#include "gap/case/parts.hpp"

namespace darwinop::gap {
namespace {

/// "stall_Nm_at_5V" of a data sheet: 5. Nothing: not such a key.
std::optional<double> voltageOf(std::string_view key, std::string_view what) {
  if (!key.starts_with(what)) return std::nullopt;
  key.remove_prefix(what.size());
  if (!key.starts_with("_at_") || !key.ends_with("V")) return std::nullopt;
  key = key.substr(4, key.size() - 5);
  double volt = 0;
  const auto [end, error] = std::from_chars(key.data(), key.data() + key.size(), volt);
  if (error != std::errc{} || end != key.data() + key.size() || !(volt >= 1 && volt <= 60)) return std::nullopt;
  return volt;
}

/// Stall and no-load figures: of the voltage that the key names, or of `supply_V`.
struct Figure {
  std::string key;
  double volt = 0;
};
std::optional<Figure> findFigure(Fields& sheet, std::string_view what, double supply_v) {
  if (sheet.has(what)) return Figure{std::string{what}, supply_v};
  for (const std::string& key : sheet.keys())
    if (const auto volt = voltageOf(key, what)) return Figure{key, *volt};
  return std::nullopt;
}

/// Torque and current at stall give kt and resistance; the voltage between them is that of the figures.
void takeStall(Fields& sheet, twin::ServoParameters& servo) {
  const auto torque = findFigure(sheet, "stall_Nm", servo.supply_v);
  const auto current = findFigure(sheet, "stall_A", servo.supply_v);
  if (torque) servo.torque_max_nm = sheet.number(torque->key, {"N m", 0.01, 100}) * servo.supply_v / torque->volt;
  if (!torque || !current) return;
  if (torque->volt != current->volt)
    sheet.fail(current->key, messages::kOtherDatasheetVoltage + torque->key + "; give both at the same");
  const double amps = sheet.number(current->key, {"A", 0.01, 100});
  servo.kt_nm_a = sheet.number(torque->key, {"N m", 0.01, 100}) / amps;
  servo.resistance_ohm = torque->volt / amps;
}

}  // namespace

Datasheet readDatasheet(Fields sheet, const twin::ServoParameters& baseline, std::vector<std::string>& warnings) {
  Datasheet out;
  out.servo = baseline;
  twin::ServoParameters& servo = out.servo;
  servo.supply_v = sheet.number("supply_V", {"V", 3, 30}, servo.supply_v);
  takeStall(sheet, servo);
  if (const auto speed = findFigure(sheet, "no_load_rpm", servo.supply_v))
    servo.speed_max_rad_s =
        sheet.number(speed->key, {"rpm", 1, 1000}) * kRadPerSecPerRpm * servo.supply_v / speed->volt;
  // P register over the divisor is PWM per step of the encoder.
  if (sheet.has("position_p_divisor") && sheet.has("pwm_limit"))
    servo.duty_per_kp_per_rad = servo.ticks_per_rev / (2 * kPi) / sheet.number("position_p_divisor", {"", 1, 65536}) /
                                sheet.number("pwm_limit", {"", 1, 65536});
  for (const ServoKey& key : servoKeys())
    if (isOfDatasheet(key)) servo.*key.member = sheet.number(key.json, ruleOf(key), servo.*key.member);
  servo.back_emf_vs_rad = servo.kt_nm_a;
  for (const ServoKey& key : servoKeys()) {
    const twin::NumberRule rule = ruleOf(key);
    if (!(servo.*key.member >= rule.low && servo.*key.member <= rule.high))
      sheet.fail(key.json, "becomes " + std::to_string(servo.*key.member) + "; a servo has " + twin::allowed(rule) +
                               "; check the figures");
  }
  out.relative_sigma = sheet.number("rel_sigma", kRelativeSigma, out.relative_sigma);
  for (const std::string_view key : {"gear_ratio", "backlash_rad", "position_p_divisor", "pwm_limit"}) sheet.leave(key);
  for (const std::string& key : sheet.untaken())
    warnings.push_back(sheet.file() + ": " + logs::quotedField("servo_datasheet." + key) + messages::kLeftAside);
  return out;
}

}  // namespace darwinop::gap
