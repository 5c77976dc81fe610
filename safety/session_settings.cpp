// Settings of a session: conversion to and from numbers, merge with the robot's.
#include "safety/session_settings.hpp"

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "safety/layers.hpp"

namespace darwinop::safety {
namespace {

/// Visitor that writes each setting to the next number.
struct ToNumbers {
  std::array<double, SessionSettings::kValues>& value;
  std::size_t at = 0;

  template <class Field, class... Rest>
  void operator()(std::string_view, const Field& field, const Rest&...) {
    value[at++] = static_cast<double>(field);
  }
};

/// Visitor that reads each setting from the next number, if valid.
struct FromNumbers {
  const std::array<double, SessionSettings::kValues>& value;
  bool keeps_stricter;  // false: takes every number that is within its range
  std::size_t at = 0;

  void operator()(std::string_view name, double& field, double low, double high, std::string_view, std::string_view) {
    const double asked = value[at++];
    if (asked >= low && asked <= high) field = chosen(name, field, asked);  // NaN fails both
  }
  template <class Choice>
  requires std::is_enum_v<Choice>
  void operator()(std::string_view name, Choice& field, std::span<const std::string_view> choices, std::string_view) {
    const double asked = value[at++];
    if (!(asked >= 0 && asked < static_cast<double>(choices.size()))) return;
    field = static_cast<Choice>(chosen(name, static_cast<double>(field), std::floor(asked)));
  }
  [[nodiscard]] double chosen(std::string_view name, double robot, double asked) const {
    return keeps_stricter ? stricter(name, robot, asked) : asked;
  }
};

}  // namespace

SessionSettings toSession(const Config& config) {
  SessionSettings settings;
  ToNumbers to_numbers{settings.numbers};
  config.visit(to_numbers);
  for (const JointRange& range : config.range) {
    settings.numbers[to_numbers.at++] = range.low.value;
    settings.numbers[to_numbers.at++] = range.high.value;
  }
  settings.given = 1;
  return settings;
}

Config fromSession(const SessionSettings& settings, std::uint32_t named) {
  Config config;
  config.visit(FromNumbers{settings.numbers, false});
  config.named = named;
  for (std::size_t i = 0; i < kJoints; ++i) {
    const std::size_t at = SessionSettings::kNumbers + 2 * i;
    config.range[i] = {Rad{settings.numbers[at]}, Rad{settings.numbers[at + 1]}};
  }
  return config;
}

Config tightened(const Config& robot, const SessionSettings& asked) noexcept {
  if (asked.given == 0) return robot;
  Config config = robot;
  config.visit(FromNumbers{asked.numbers, true});
  for (std::size_t i = 0; i < kJoints; ++i) {
    const std::size_t at = SessionSettings::kNumbers + 2 * i;
    const double low = std::max(asked.numbers[at], robot.range[i].low.value);
    const double high = std::min(asked.numbers[at + 1], robot.range[i].high.value);
    // NaN and infinities: std::max and std::min return their second argument or fail the comparison.
    if (low < high && low >= robot.range[i].low.value && high <= robot.range[i].high.value)
      config.range[i] = {Rad{low}, Rad{high}};
  }
  return config.contradiction() == nullptr ? config : robot;
}

}  // namespace darwinop::safety
