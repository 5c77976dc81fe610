#include "gap/case/declarations.hpp"

#include <algorithm>
#include <charconv>

#include "core/text/joined.hpp"
#include "core/text/nearest.hpp"
#include "gap/case/baseline_keys.hpp"
#include "gap/case/messages.hpp"
#include "gap/case/parts.hpp"
#include "gap/case/write_time.hpp"

namespace darwinop::gap {
namespace {

constexpr BenchKey kBench[] = {{"kp", {}, "P register"},
                               {"payload_kg", {}, "weight at the end of the arm"},
                               {"length_m", {}, "from the axis to that weight"},
                               {"arm_mass_kg", 0, "the arm without the weight"},
                               {"supply_V", {}, "nominal supply"}};
/// Of logs and their rows.
constexpr std::string_view kOfLogs[] = {"goal_order", "motor",        "joint", "torque_on",  "from_s",
                                        "to_s",       "hangs_at_rad", "axis",  kWriteTimeKey};
constexpr std::string_view kSigma = "_rel_sigma";
constexpr std::string_view kDutyGain = "duty_per_kp_per_rad";

/// Of a data sheet. Figures at stall may name another voltage than the supply: stall_Nm_at_5V.
constexpr std::string_view kStall[] = {"stall_Nm", "stall_A"}, kGain[] = {"position_p_divisor", "pwm_limit"};
constexpr std::string_view kOfManual = "of the manual; or position_p_divisor and pwm_limit";

bool isOfBench(std::string_view key) {
  return std::ranges::find(kBench, key, &BenchKey::key) != std::end(kBench);
}

bool isOfServo(std::string_view key) {
  return std::ranges::any_of(kStall, [&](std::string_view one) { return key.starts_with(one); }) ||
         std::ranges::find(kGain, key) != std::end(kGain) ||
         std::ranges::any_of(servoKeys(), [&](const ServoKey& one) { return one.json == key && one.of_voltage_p; });
}

std::vector<std::string> allKeys() {
  std::vector<std::string> keys;
  for (const BenchKey& one : kBench) keys.emplace_back(one.key);
  keys.insert(keys.end(), std::begin(kOfLogs), std::end(kOfLogs));
  keys.insert(keys.end(), std::begin(kStall), std::end(kStall));
  keys.insert(keys.end(), std::begin(kGain), std::end(kGain));
  for (const ServoKey& one : servoKeys())
    if (one.of_voltage_p && one.json != "supply_V") keys.emplace_back(one.json);
  return keys;
}

/// The closest key, or all.
std::string suggestionFor(const std::string& key) {
  const std::vector<std::string> keys = allKeys();
  const std::vector<std::string_view> candidates{keys.begin(), keys.end()};
  const std::size_t voltage = key.find("_at_");  // of the data sheet, any
  const std::string of_voltage = voltage == std::string::npos ? "" : key.substr(voltage);
  if (const auto close = text::nearest(key.substr(0, voltage), candidates))
    return "; did you mean " + std::string{*close} + of_voltage + "?";
  return "; there are " + text::joined(keys, ", ") +
         ", and load_raw and the like with an encoding, and payload_kg_rel_sigma and the like";
}

double numberIn(const std::string& key, const std::string& text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size())
    throw BadInput("--declare " + key + "=" + text + " " +
                   (text.find(',') == std::string::npos ? messages::kNotKeyValue : messages::kDecimalComma));
  return value;
}

}  // namespace

std::span<const BenchKey> benchKeys() {
  return kBench;
}

Declarations::Declarations(const std::vector<std::string>& words) {
  for (const std::string& word : words) {
    const std::size_t equals = word.find('=');
    if (equals == std::string::npos || equals == 0 || equals + 1 == word.size())
      throw BadInput("--declare " + word + " " + messages::kNotKeyValue);
    const std::string key = word.substr(0, equals), value = word.substr(equals + 1);
    if (std::ranges::find(kOfLogs, key) != std::end(kOfLogs) || isOfBench(key))
      bench_[key] = value;
    else if (key.ends_with("_raw"))
      encodings_[key] = value;
    else if (const std::string number = key.substr(0, key.size() - std::min(key.size(), kSigma.size()));
             key == number + std::string{kSigma} && (isOfServo(number) || isOfBench(number)))
      sigmas_[number] = numberIn(key, value);
    else if (isOfServo(key))
      servo_[key] = numberIn(key, value);
    else
      throw BadInput("--declare " + key + " " + messages::kNotDeclarable + suggestionFor(key));
  }
}

std::optional<std::string> Declarations::text(std::string_view key) const {
  const auto found = bench_.find(key);
  return found == bench_.end() ? std::nullopt : std::optional{found->second};
}

std::optional<double> Declarations::number(std::string_view key) const {
  const std::optional<std::string> value = text(key);
  return value ? std::optional{numberIn(std::string{key}, *value)} : std::nullopt;
}

bool Declarations::describes(std::string_view key) const {
  return std::ranges::any_of(servo_, [&](const auto& one) { return one.first.starts_with(key); });
}

double Declarations::addServo(const std::string& key, double value, double relative_sigma) {
  servo_[key] = value;
  if (relative_sigma > 0) sigmas_.try_emplace(key, relative_sigma);
  const auto found = sigmas_.find(key);
  return found == sigmas_.end() ? 0 : found->second;
}

std::string Declarations::missing(std::string_view key, std::string_view meaning) {
  return "\n  --declare " + std::string{key} + "=...   " + std::string{meaning};
}

std::string Declarations::missingOfServo() const {
  std::string out;
  for (const std::string_view key : kStall)
    if (!describes(key))
      out += missing(std::string{key} + "_at_12V", "at stall, of the data sheet, with the voltage that it names");
  const bool gain = servo_.contains(std::string{kDutyGain}) || halvesOfGain() == std::size(kGain);
  if (!gain) out += missing(kDutyGain, kOfManual);
  return out;
}

std::size_t Declarations::halvesOfGain() const {
  return static_cast<std::size_t>(
      std::ranges::count_if(kGain, [&](std::string_view key) { return servo_.contains(std::string{key}); }));
}

std::string Declarations::missingOfGain() const {
  return halvesOfGain() == 1 ? missing(kDutyGain, kOfManual) : "";
}

twin::ServoParameters Declarations::servoFrom(twin::ServoParameters servo, std::vector<std::string>& notes) const {
  servo.law = twin::Law::kVoltageP;
  servo.supply_v = number("supply_V").value_or(servo.supply_v);
  Json sheet = Json::object();
  for (const auto& [key, value] : servo_) sheet[key] = value;
  // Of both laws, and so not of the data sheet.
  for (const ServoKey& key : servoKeys())
    if (const auto found = sheet.find(key.json); found != sheet.end() && !isOfDatasheet(key)) {
      servo.*key.member = found->get<double>();
      sheet.erase(found);
    }
  servo = readDatasheet(Fields{sheet, "--declare", ""}, servo, notes).servo;
  if (!servo_.contains("armature_kgm2")) notes.emplace_back(messages::kArmatureAssumed);
  return servo;
}

}  // namespace darwinop::gap
