// What a controller asks for that a daemon does not do for it.
#include "link/daemon_warnings.hpp"

#include <algorithm>
#include <vector>

namespace darwinop::link {
namespace {

/// Every setting as a number, in the order of visit().
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

std::vector<double> numbers(const safety::Config& config) {
  Numbers found;
  config.visit(found);
  for (const safety::JointRange& range : config.range)
    found.all.insert(found.all.end(), {range.low.value, range.high.value});
  return found.all;
}

std::string inMs(Nanos time) {
  std::string text = std::to_string(std::chrono::duration<double, std::milli>(time).count());
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text;
}

}  // namespace

std::string daemonWarnings(const Request& request, Nanos daemons_period) {
  std::string text;
  if (!request.record_path.empty())
    text += "darwinop: " + request.record_path +
            " is not written: the loop runs in the daemon, which records by itself: darwinop runtime --record FILE\n";
  if (request.period != daemons_period)
    text += "darwinop: the daemon's period of " + inMs(daemons_period) + " ms holds, not the " + inMs(request.period) +
            " ms asked for; restart it with: darwinop runtime --period " + inMs(request.period) + "\n";
  if (numbers(request.safety) != numbers(safety::Config{}))
    text +=
        "darwinop: [Safety] and [Limits] of this controller's config.ini do not hold: the daemon has its own; give "
        "it a file with: darwinop runtime --config FILE\n";
  return text;
}

}  // namespace darwinop::link
