// Parses settings of the safety layer.
#include "safety/config.hpp"

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <tuple>
#include <type_traits>

#include "core/text/number_text.hpp"

namespace darwinop::safety {
namespace {

std::string show(double value) {
  return text::generalText(value, 6);
}

[[noreturn]] void refuse(std::string_view section, std::string_view key, std::string_view value,
                         const std::string& allowed) {
  throw std::runtime_error("config.ini, [" + std::string{section} + "] " + std::string{key} + " = " +
                           std::string{value} + ": " + allowed);
}

/// Visitor that sets the field named `key`.
struct Setter {
  std::string_view key, value;
  std::size_t seen = 0;  // settings visited so far
  std::optional<std::size_t> found{};

  void operator()(std::string_view name, double& field, double low, double high, std::string_view unit,
                  std::string_view) {
    const std::size_t at = seen++;
    if (name != key) return;
    found = at;
    const auto parsed = text::numberFromText(value);
    if (!parsed || *parsed < low || *parsed > high) {
      std::string allowed = "give a number from " + show(low) + " to " + show(high);
      if (!unit.empty()) allowed += " " + std::string{unit};
      refuse("Safety", key, value, allowed);
    }
    field = *parsed;
  }

  template <class Choice>
  requires std::is_enum_v<Choice>
  void operator()(std::string_view name, Choice& field, std::span<const std::string_view> choices, std::string_view) {
    const std::size_t at = seen++;
    if (name != key) return;
    found = at;
    std::string allowed = "give one of";
    for (std::size_t i = 0; i < choices.size(); ++i) {
      if (choices[i] == value) {
        field = static_cast<Choice>(i);
        return;
      }
      allowed += (i == 0 ? " " : ", ") + std::string{choices[i]};
    }
    refuse("Safety", key, value, allowed);
  }
};

std::string knownKeys(const Config& config) {
  std::string keys;
  config.visit([&](std::string_view name, const auto&...) { keys += (keys.empty() ? "" : ", ") + std::string{name}; });
  return keys;
}

void setRange(std::array<JointRange, kJoints>& ranges, std::string_view key, std::string_view value) {
  const auto joint = findJoint(key);
  if (!joint) refuse("Limits", key, value, kNoSuchJoint);
  const JointRange hard = hardRange(*joint);
  const auto comma = value.find(',');
  const auto low = text::numberFromText(value.substr(0, comma));
  const auto high = comma == value.npos ? std::nullopt : text::numberFromText(value.substr(comma + 1));
  // Half a tick of tolerance: a limit that was printed with a few digits is accepted.
  const double slack = kRadPerTick / 2;
  if (!low || !high || *low >= *high || *low < hard.low.value - slack || *high > hard.high.value + slack)
    refuse("Limits", key, value,
           "give two numbers, low, high, in rad, from " + show(hard.low.value) + " to " + show(hard.high.value) +
               ": limits can be narrowed, not widened");
  ranges[index(*joint)] = {Rad{std::max(*low, hard.low.value)}, Rad{std::min(*high, hard.high.value)}};
}

}  // namespace

void Config::set(std::string_view section, std::string_view key, std::string_view value) {
  key = text::withoutBlanks(key);
  value = text::withoutBlanks(value);
  if (section == "Limits") return setRange(range, key, value);
  if (section != "Safety") refuse(section, key, value, "safety reads the sections [Safety] and [Limits]");
  Setter setter{key, value};
  visit(setter);
  if (!setter.found) refuse(section, key, value, "no such setting; there are " + knownKeys(*this));
  named.set(*setter.found);
}

void Config::check() const {
  visit([](std::string_view name, const auto& field, const auto&... rest) {
    if constexpr (sizeof...(rest) == 4) {  // a number: low, high, unit, why
      const auto [low, high, unit, why] = std::tuple{rest...};
      if (!(field >= low && field <= high))
        refuse("Safety", name, show(field), "give a number from " + show(low) + " to " + show(high));
    }
  });
  for (std::size_t i = 0; i < kJoints; ++i) {
    const JointRange hard = hardRange(static_cast<Joint>(i));
    if (!(range[i].low >= hard.low && range[i].high <= hard.high && range[i].low < range[i].high))
      refuse("Limits", kJointTable[i].name, show(range[i].low.value) + ", " + show(range[i].high.value),
             "limits can be narrowed, not widened");
  }
  if (const char* const sentence = contradiction())
    throw std::runtime_error(std::string{"config.ini, [Safety]: "} + sentence);
}

const char* Config::contradiction() const noexcept {
  if (gentle_speed > max_joint_speed) return "gentle_speed must not be above max_joint_speed";
  if (battery_empty > battery_low) return "battery_empty must not be above battery_low";
  if (hot > overheat) return "hot must not be above overheat";
  if (stall_ms / 1000 > gone_s) return "stall_ms must not be above gone_s";
  if (period <= Nanos{0}) return "the period of the loop must be above 0";
  return nullptr;
}

}  // namespace darwinop::safety
