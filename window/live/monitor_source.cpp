#include "window/live/monitor_source.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "monitor/messages.hpp"
#include "window/messages.hpp"

namespace darwinop::window {
namespace {

using nlohmann::json;

/// Null and whatever is no number: NaN.
double numberOf(const json& value) {
  return value.is_number() ? value.get<double>() : kUnknown;
}

std::string_view textOf(const json& value) {
  return value.is_string() ? std::string_view{value.get_ref<const std::string&>()} : std::string_view{};
}

/// Of an array's element; NaN if it has none.
double at(const json& object, const char* name, std::size_t i) {
  const auto found = object.find(name);
  return found != object.end() && found->is_array() && i < found->size() ? numberOf((*found)[i]) : kUnknown;
}

Freshness ageOf(double age) {
  constexpr double kMostCycles = 1e9;
  return {age >= 0 && age <= kMostCycles ? static_cast<std::uint32_t>(age) : Freshness::kNever};
}

JointSensors jointOf(const json& joints, std::size_t i) {
  JointSensors out;
  out.motion = ageOf(at(joints, "age", i));
  out.position = Rad{at(joints, "position", i)};
  out.velocity = RadPerSec{at(joints, "speed", i)};
  out.load = at(joints, "load", i);
  out.polled = ageOf(at(joints, "health_age", i));
  out.torque_limit = NewtonMeter{at(joints, "torque_limit", i)};
  out.commanded = Rad{at(joints, "goal", i)};
  out.driven = !std::isnan(out.commanded.value);
  return out;
}

json parsed(std::string_view message) {
  return json::parse(message.begin(), message.end(), nullptr, false);
}

const json& member(const json& object, const char* name) {
  static const json kNothing;
  const auto found = object.find(name);
  return found == object.end() ? kNothing : *found;
}

}  // namespace

std::optional<Sensors> sensorsOfState(std::string_view message, double period_s) {
  const json state = parsed(message);
  if (!state.is_object() || member(state, "type") != "state") return std::nullopt;
  const json &joints = member(state, "joints"), &board = member(state, "board");
  const double cycle = numberOf(member(state, "cycle")), time_s = numberOf(member(state, "time"));
  constexpr double kMost = 1e9;  // s and cycles: more than any run
  if (!joints.is_object() || !board.is_object() || !(cycle >= 1 && cycle <= kMost) || !(std::abs(time_s) <= kMost))
    return std::nullopt;
  Sensors out;
  out.cycle = static_cast<std::uint64_t>(cycle);
  out.time_ns = std::llround(time_s * 1e9);
  out.period_ns = std::llround(period_s * 1e9);
  for (std::size_t i = 0; i < kJoints; ++i) out.joint[i] = jointOf(joints, i);
  const auto state_name = std::ranges::find(kStateNames, textOf(member(state, "state")));
  if (state_name != kStateNames.end())
    out.safety.state = static_cast<State>(std::distance(kStateNames.begin(), state_name));
  out.board.absent = member(board, "absent") == true;
  out.board.motion = ageOf(numberOf(member(board, "age")));
  for (std::size_t i = 0; i < 3; ++i) {
    out.board.gyro[i] = RadPerSec{at(board, "gyro", i)};
    out.board.accelerometer[i] = MeterPerSec2{at(board, "accelerometer", i)};
  }
  out.board.voltage = Volt{numberOf(member(board, "voltage"))};
  return out;
}

std::optional<double> periodOfHello(std::string_view message) {
  constexpr double kShortest = 0.001, kLongest = 1;  // s; a shorter one would need windows of any size
  const json hello = parsed(message);
  if (!hello.is_object() || member(hello, "type") != "hello") return std::nullopt;
  const double period_s = numberOf(member(hello, "period"));
  return period_s >= kShortest && period_s <= kLongest ? std::optional{period_s} : std::nullopt;
}

MonitorSource::MonitorSource(net::Ipv4 address, std::uint16_t port, std::string name)
    : name_{std::move(name)},
      reason_{messages::kNoMonitor + name_},
      client_{[&] {
                web::WebSocketClientConfig config;
                config.address = address;
                config.port = port;
                config.subprotocol = monitor::kSubprotocol;
                return config;
              }(),
              {.received =
                   [this](std::string_view text, bool binary) {
                     if (!binary) received(text);
                   },
               .disconnected =
                   [this](const std::string& why) { reason_ = messages::kNoMonitor + name_ + " (" + why + ")"; }}} {
  client_.request(json{{"rate", monitor::kMostRate}}.dump());  // every cycle
}

void MonitorSource::poll(Nanos /*now*/, const Take& take) {
  take_ = &take;
  client_.poll();
  take_ = nullptr;
}

void MonitorSource::received(std::string_view message) {
  if (period_s_ > 0) {
    if (const std::optional<Sensors> sensors = sensorsOfState(message, period_s_)) {
      reason_.clear();
      gap::live::LiveCycle cycle{*sensors, {}};
      cycle.p_gain.fill(kUnknown);
      return (*take_)(cycle);
    }
  }
  const json other = parsed(message);
  if (!other.is_object()) return;
  if (const std::optional<double> period_s = periodOfHello(message)) {
    period_s_ = *period_s;
  } else if (member(other, "type") == "gone" && member(other, "reason").is_string()) {
    reason_ = member(other, "reason").get<std::string>();
  }
}

}  // namespace darwinop::window
