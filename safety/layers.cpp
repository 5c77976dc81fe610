#include "safety/layers.hpp"

#include <algorithm>
#include <stdexcept>

#include "core/text/ini_text.hpp"
#include "core/text/number_text.hpp"

namespace darwinop::safety {
namespace {

struct Numbers {
  std::vector<double> all;
  void operator()(std::string_view, double value, double, double, std::string_view, std::string_view) {
    all.push_back(value);
  }
  template <class Choice>
  void operator()(std::string_view, Choice value, std::span<const std::string_view>, std::string_view) {
    all.push_back(static_cast<double>(value));
  }
};

/// Visitor that merges the settings of the robot's file into the controller's.
struct Merger {
  const std::vector<double>& robots;
  const std::bitset<32>&robot_named, &controller_named;
  std::size_t at = 0;

  template <class Field, class... Rest>
  void operator()(std::string_view name, Field& field, const Rest&...) {
    if (robot_named[at]) {
      const double robot = robots[at];
      field = static_cast<Field>(controller_named[at] ? stricter(name, robot, static_cast<double>(field)) : robot);
    }
    ++at;
  }
};

std::string show(const JointRange& range) {
  return text::generalText(range.low.value, 4) + ", " + text::generalText(range.high.value, 4);
}

void intersect(JointRange& range, const JointRange& with, std::string_view joint, const Layer& robot,
               const Layer& controller) {
  const JointRange both{std::max(range.low, with.low), std::min(range.high, with.high)};
  if (both.low >= both.high)
    throw std::runtime_error("[Limits] " + std::string{joint} + ": " + robot.file + " allows " + show(with) + " and " +
                             controller.file + " allows " + show(range) +
                             " rad, and no angle is in both; change one of the two");
  range = both;
}

}  // namespace

double stricter(std::string_view name, double robot, double controller) noexcept {
  const auto* const rule = std::ranges::find(kStricterWins, name, &StricterRow::name);
  if (rule == kStricterWins.end()) return controller;
  return rule->wins == Stricter::kHigher ? std::max(robot, controller) : std::min(robot, controller);
}

std::vector<double> numbers(const Config& config) {
  Numbers found;
  config.visit(found);
  for (const JointRange& range : config.range) found.all.insert(found.all.end(), {range.low.value, range.high.value});
  return found.all;
}

Config layered(const Layer& robot, const Layer& controller) {
  Config config = controller.config;
  const std::vector<double> robots = numbers(robot.config);
  config.visit(Merger{robots, robot.config.named, controller.config.named});
  config.named |= robot.config.named;
  config.absent |= robot.config.absent;
  config.left_out |= robot.config.left_out;
  config.no_writes |= robot.config.no_writes;
  for (std::size_t i = 0; i < kJoints; ++i)
    intersect(config.range[i], robot.config.range[i], kJointTable[i].name, robot, controller);
  try {
    config.check();
  } catch (const std::runtime_error& wrong) {
    throw std::runtime_error(robot.file + " and " + controller.file +
                             " together: " + std::string{text::withoutFile(wrong.what())});
  }
  return config;
}

}  // namespace darwinop::safety
