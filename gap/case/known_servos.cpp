// The table of servos, and what follows from it.
#include "gap/case/known_servos.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdio>

#include "core/servo_limits.hpp"
#include "core/servo_models.hpp"
#include "core/units.hpp"
#include "gap/case/messages.hpp"

namespace darwinop::gap {
namespace {

constexpr const char* kSheetSource = "ROBOTIS' e-manual";
constexpr std::uint16_t kMx28Number = 29;
constexpr std::string_view kSecondFirmware = "2.0";

/// Stall torque and no-load speed are those of kServoModels.
struct SheetRow {
  std::string_view motor;
  std::uint16_t number;  // of kServoModels
  double stall_a;        // at 12 V; source: the table "Specifications" of ROBOTIS' e-manual of this model
};
constexpr SheetRow kSheets[] = {{"mx28", kMx28Number, kStallCurrent}, {"mx64", 310, 4.1}, {"mx106", 320, 5.2}};

// Position loop of firmware of protocol 1: as that of the twin's MX-28. Of protocol 2: e-manual, Position P Gain and
// PWM Limit of MX(2.0).
constexpr double kGreatestKpOfProtocol1 = kMaxPGain / kGainPerCount;
constexpr double kDivisorOfProtocol2 = 128, kPwmLimitOfProtocol2 = 885;

constexpr double kLeastKtSigma = 0.1;  // as of a bench whose motor is declared, benchPriors()
constexpr double kArmatureSigma = 1;   // up to seven times as much (kFarthestPriorSigmas)

std::string lowerCase(std::string_view text) {
  std::string out{text};
  std::ranges::transform(out, out.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return out;
}

std::string briefNumber(double value) {
  char text[32];
  return {text, static_cast<std::size_t>(std::snprintf(text, sizeof text, "%.3g", value))};
}

double noLoadRadS(const ServoModel& model) {
  return model.no_load_rpm * kRadPerSecPerRpm;
}

/// Stall torque is kt * current less friction, no-load speed is below supply / kt by the same friction: if it is
/// constant, kt is the geometric mean of what each of the two gives. Half of their distance is the sigma.
SheetNumber torqueConstant(const SheetRow& row, const ServoModel& model) {
  const double by_torque = model.stall_torque / row.stall_a, by_speed = kNominalSupply / noLoadRadS(model);
  return {.key = "kt_Nm_A",
          .value = std::sqrt(by_torque * by_speed),
          .relative_sigma = std::max(kLeastKtSigma, std::abs(std::log(by_speed / by_torque)) / 2),
          .unless = {"kt_Nm_A", "stall_Nm", "stall_A"},
          .source = "between " + briefNumber(by_torque) + " by stall torque and current and " + briefNumber(by_speed) +
                    " by no-load speed"};
}

/// Not on the data sheet. Motors of one make run up in about the same time without load, J * speed / torque, whatever
/// their size and gear.
SheetNumber armatureOf(const ServoModel& model, const twin::ServoParameters& mx28) {
  const ServoModel& known = *findServoModel(kMx28Number);
  const double scale = model.stall_torque / noLoadRadS(model) / (known.stall_torque / noLoadRadS(known));
  return {.key = "armature_kgm2",
          .value = mx28.armature_kgm2 * scale,
          .relative_sigma = kArmatureSigma,
          .unless = {"armature_kgm2"},
          .source = messages::kNotOnSheet};
}

std::vector<SheetNumber> gainOf(bool protocol_2) {
  if (!protocol_2)
    return {{.key = "duty_per_kp_per_rad",
             .value = twin::ServoParameters{}.duty_per_kp_per_rad,
             .unless = {"duty_per_kp_per_rad", "position_p_divisor", "pwm_limit"},
             .source = "firmware of protocol 1, since no kp exceeds 254; protocol 2 has position_p_divisor=128 and "
                       "pwm_limit=885"}};
  return {{.key = "position_p_divisor",
           .value = kDivisorOfProtocol2,
           .unless = {"duty_per_kp_per_rad", "position_p_divisor"},
           .source = "firmware of protocol 2, by kp or name"},
          {.key = "pwm_limit",
           .value = kPwmLimitOfProtocol2,
           .unless = {"duty_per_kp_per_rad", "pwm_limit"},
           .source = "as before"}};
}

}  // namespace

std::string motorName(std::string_view written) {
  const std::string name = lowerCase(written);
  const std::size_t series = name.find("mx");
  if (series == name.npos) return std::string{written};
  const std::size_t digits = name.find_first_not_of("-_ ", series + 2);
  const std::size_t end = std::min(name.find_first_not_of("0123456789", digits), name.size());
  if (digits == name.npos || end == digits) return std::string{written};
  const bool second = name.find(kSecondFirmware, end) != name.npos;
  return "mx" + name.substr(digits, end - digits) + (second ? "(" + std::string{kSecondFirmware} + ")" : "");
}

std::optional<std::vector<SheetNumber>> numbersOf(const std::string& motor, double greatest_kp,
                                                  const twin::ServoParameters& mx28) {
  const std::string name = motorName(motor);
  const std::string_view series = std::string_view{name}.substr(0, name.find('('));
  const auto* const row = std::ranges::find(kSheets, series, &SheetRow::motor);
  if (row == std::end(kSheets)) return std::nullopt;
  const bool protocol_2 = series.size() < name.size() || greatest_kp > kGreatestKpOfProtocol1;
  std::vector<SheetNumber> numbers;
  if (row->number != kMx28Number) {
    const ServoModel& model = *findServoModel(row->number);
    numbers = {{.key = "stall_Nm_at_12V", .value = model.stall_torque, .unless = {"stall_Nm"}, .source = kSheetSource},
               {.key = "stall_A_at_12V", .value = row->stall_a, .unless = {"stall_A"}, .source = kSheetSource},
               torqueConstant(*row, model),
               armatureOf(model, mx28)};
  } else if (!protocol_2) {
    return numbers;
  }
  for (SheetNumber& number : gainOf(protocol_2)) numbers.push_back(std::move(number));
  return numbers;
}

std::vector<std::string> declareSheet(const std::string& motor, const std::vector<SheetNumber>& numbers,
                                      Declarations& declared) {
  std::vector<const SheetNumber*> taken;  // all are chosen before any of them counts as declared
  for (const SheetNumber& number : numbers)
    if (std::ranges::none_of(number.unless, [&](std::string_view key) { return declared.describes(key); }))
      taken.push_back(&number);
  std::vector<std::string> notes;
  for (const SheetNumber* const number : taken) {
    const double sigma = declared.addServo(number->key, number->value, number->relative_sigma);
    notes.push_back("motor \"" + motor + "\" has " + number->key + "=" + briefNumber(number->value) +
                    (sigma > 0 ? " +-" + briefNumber(100 * sigma) + " %" : "") + ": " + number->source +
                    messages::kSheetNumber);
  }
  return notes;
}

}  // namespace darwinop::gap
