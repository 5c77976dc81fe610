// The one file here that knows how JSON is made.
#include "remote/monitor/messages.hpp"

#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>
#include <utility>

#include "core/conversions.hpp"
#include "core/joints.hpp"
#include "remote/jpeg/image_size.hpp"
#include "runtime/report.hpp"
#include "runtime/version.hpp"
#include "webots/counts.hpp"

namespace darwinop::monitor {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kHealthStale = 3;  // s; every servo is looked at within one
constexpr std::array kChains{"right_arm", "left_arm", "head", "right_leg", "left_leg"};
constexpr std::array kReactions{"report", "slow", "hold", "kneel", "limp", "stop_sending"};
constexpr std::array<std::uint32_t, 10> kEdges{10, 20, 50, 100, 200, 500, 1000, 2000, 5000, 10000};  // us

std::string written(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);  // names come from memory that others write
}

/// Five digits behind the point: finer than any count of the robot.
Json figure(double value, double digits = 1e5) {
  if (!std::isfinite(value)) return nullptr;
  const double rounded = std::round(value * digits) / digits;
  constexpr double kExact = 9e15;  // doubles count by ones up to here
  if (std::abs(rounded) < kExact && rounded == std::trunc(rounded))
    return static_cast<std::int64_t>(rounded);  // 0, not -0.0
  return rounded;
}

template <std::size_t N>
Json textOfArray(const char (&text)[N]) {
  return std::string{text, strnlen(text, N)};
}

Json ageOf(Freshness freshness) {
  return freshness.ever() ? Json(freshness.age) : Json(nullptr);
}

bool healthFresh(const JointSensors& joint, double period) {
  return joint.health.ever() && joint.health.age * period <= kHealthStale;
}

bool motionFresh(Freshness freshness) {
  return freshness.age < runtime::kStaleAge;
}

/// One value of each joint.
template <class Value>
Json each(const Sensors& seen, Value value) {
  Json all = Json::array();
  for (const JointSensors& joint : seen.joint) all.push_back(value(joint));
  return all;
}

Json jointsOf(const Sensors& seen) {
  const double period = static_cast<double>(seen.period_ns) * 1e-9;
  const auto motion = [](double value, const JointSensors& j) {
    return motionFresh(j.motion) ? figure(value) : nullptr;
  };
  const auto health = [period](double value, const JointSensors& j) {
    return healthFresh(j, period) ? figure(value) : nullptr;
  };
  using J = const JointSensors&;
  Json joints;
  joints["position"] = each(seen, [&](J j) { return motion(j.position.value, j); });
  joints["goal"] = each(seen, [](J j) { return j.driven ? figure(j.commanded.value) : nullptr; });
  joints["speed"] = each(seen, [&](J j) { return motion(j.velocity.value, j); });
  joints["load"] = each(seen, [&](J j) { return motion(j.load, j); });
  joints["age"] = each(seen, [](J j) { return ageOf(j.motion); });
  joints["driven"] = each(seen, [](J j) { return Json(j.driven); });
  Json silent = Json::array();
  for (std::size_t i = 0; i < kJoints; ++i) silent.push_back(seen.silent[i]);
  joints["silent"] = std::move(silent);
  joints["temperature"] = each(seen, [&](J j) { return health(j.temperature.value, j); });
  joints["voltage"] = each(seen, [&](J j) { return health(j.voltage.value, j); });
  joints["torque"] = each(seen, [&](J j) { return healthFresh(j, period) ? Json(j.torque_enabled) : Json(nullptr); });
  joints["torque_limit"] = each(seen, [&](J j) { return health(j.torque_limit.value, j); });
  joints["health_age"] = each(seen, [](J j) { return ageOf(j.health); });
  return joints;
}

template <class Values>
Json axes(bool fresh, const Values& values) {
  Json all = Json::array();
  for (const auto& value : values) all.push_back(fresh ? figure(value.value) : nullptr);
  return all;
}

template <class Values>
Json countsOf(bool fresh, const Values& values, const Register& law) {
  Json all = Json::array();
  for (const auto& value : values) all.push_back(fresh ? figure(facade::countFrom(value.value, law), 1) : nullptr);
  return all;
}

std::string colourText(std::uint16_t word) {
  char text[16];
  std::snprintf(text, sizeof text, "#%06x", static_cast<unsigned>(facade::rgb24From15(word)) & 0xFFFFFFU);
  return text;
}

Json boardOf(const BoardSensors& board) {
  const bool fresh = motionFresh(board.motion);
  const auto known = [fresh](Json value) { return fresh ? std::move(value) : Json(nullptr); };
  Json text;
  text["age"] = ageOf(board.motion);
  text["accelerometer"] = axes(fresh, board.accelerometer);
  text["gyro"] = axes(fresh, board.gyro);
  text["accelerometer_count"] = countsOf(fresh, board.accelerometer, facade::kAccelRegister);
  text["gyro_count"] = countsOf(fresh, board.gyro, facade::kGyroRegister);
  text["mode_button"] = known((board.buttons & 1) != 0);
  text["start_button"] = known((board.buttons & 2) != 0);
  text["voltage"] = known(figure(board.voltage.value));
  text["servo_power"] = known(board.servo_power);
  text["microphone"] = known(figure(board.microphone_left));
  text["led"]["panel"] = known(board.led_panel);
  text["led"]["head"] = known(colourText(board.led_head));
  text["led"]["eye"] = known(colourText(board.led_eye));
  return text;
}

Json jointTable() {
  Json joints = Json::array();
  for (const JointRow& row : kJointTable)
    joints.push_back({{"id", row.id},
                      {"name", row.name},
                      {"sensor", std::string{row.name} + "S"},
                      {"meaning", row.anatomical},
                      {"chain", kChains[static_cast<std::size_t>(row.chain)]},
                      {"low", figure(radFromTicks(row.low).value)},
                      {"high", figure(radFromTicks(row.high).value)},
                      {"start", figure(radFromTicks(row.start).value)}});
  return joints;
}

Json faultTable() {
  Json faults = Json::array();
  for (const FaultRow& row : kFaultTable)
    faults.push_back({{"code", static_cast<int>(row.fault)},
                      {"name", row.name},
                      {"meaning", row.meaning},
                      {"remedy", row.remedy},
                      {"reaction", kReactions[static_cast<std::size_t>(row.reaction)]},
                      {"latched", row.latched}});
  return faults;
}

Json deviceTable() {
  Json devices = Json::array();
  devices.push_back({{"name", "Accelerometer"}, {"type", "accelerometer"}, {"unit", "m/s2"}});
  devices.push_back({{"name", "Gyro"}, {"type", "gyro"}, {"unit", "rad/s"}});
  devices.push_back({{"name", "Camera"},
                     {"type", "camera"},
                     {"width", remote::kWholeImage.width},
                     {"height", remote::kWholeImage.height}});
  for (const char* led : {"HeadLed", "EyeLed", "BackLedRed", "BackLedGreen", "BackLedBlue"})
    devices.push_back({{"name", led}, {"type", "led"}});
  return devices;
}

std::uint32_t countBetween(const runtime::HistogramView& view, std::uint32_t low, std::uint32_t high) {
  std::uint32_t sum = 0;
  for (std::size_t bin = 0; bin < runtime::Bins::kCount; ++bin)
    if (runtime::Bins::low(bin) >= low && runtime::Bins::low(bin) < high) sum += view.count[bin];
  return sum;
}

Json histogramOf(const runtime::HistogramView& view) {
  Json counts = Json::array();
  std::uint32_t low = 0;
  for (const std::uint32_t edge : kEdges) counts.push_back(countBetween(view, std::exchange(low, edge), edge));
  counts.push_back(countBetween(view, low, UINT32_MAX));
  return {{"edges_us", kEdges}, {"counts", std::move(counts)}};
}

Json spread(const runtime::HistogramView& view, double unit) {
  return {{"p50", figure(view.percentile(0.5) * unit)},
          {"p99", figure(view.percentile(0.99) * unit)},
          {"max", figure(view.max() * unit)}};
}

Json driverOf(pid_t pid) {
  if (pid == 0) return nullptr;
  Json driver;
  driver["pid"] = pid > 0 ? Json(pid) : Json(nullptr);
  return driver;
}

/// Empty: understood.
std::string take(const Json& asked, const char* name, double most, double& into) {
  const auto found = asked.find(name);
  if (found == asked.end()) return {};
  const double value = found->is_number() ? found->get<double>() : kUnknown;
  if (!(value >= 0 && value <= most))
    return std::string{name} + " must be a number from 0 to " + std::to_string(static_cast<int>(most)) + ", in Hz";
  into = value;
  return {};
}

}  // namespace

std::optional<Wishes> readWishes(std::string_view text, const Wishes& before, std::string& why) {
  const Json asked = Json::parse(text.begin(), text.end(), nullptr, false);
  Wishes wishes = before;
  why.clear();
  if (!asked.is_object()) why = "say what you want as a JSON object, such as {\"rate\": 20, \"camera\": 5}";
  if (why.empty()) why = take(asked, "rate", kMostRate, wishes.rate);
  if (why.empty()) why = take(asked, "camera", kMostPictures, wishes.camera);
  return why.empty() ? std::optional{wishes} : std::nullopt;
}

std::string helloText(const runtime::LoopInfo* info, const Wishes& wishes) {
  Json text;
  text["type"] = "hello";
  text["protocol"] = 1;
  text["runtime"] = runtime::version();
  text["robot"] = info != nullptr ? textOfArray(info->robot) : nullptr;
  text["port"] = info != nullptr ? textOfArray(info->port) : nullptr;
  text["period"] = info != nullptr ? figure(static_cast<double>(info->period_ns) * 1e-9, 1e9) : nullptr;
  text["rate"] = figure(wishes.rate);
  text["camera"] = figure(wishes.camera);
  text["most"] = {{"rate", kMostRate}, {"camera", kMostPictures}};
  text["joints"] = jointTable();
  text["devices"] = deviceTable();
  text["signs"] = {"a positive angle or speed turns the servo's horn counter-clockwise",
                   "left and right partners are mounted mirrored: the mirrored angle has the other sign",
                   "a positive load pushes counter-clockwise",
                   "upright and at rest the accelerometer reads 0, 0, +9.8 m/s2"};
  text["faults"] = faultTable();
  text["limits"] = kLimitNames;
  return written(text);
}

std::string stateText(const Sensors& seen) {
  const auto state = static_cast<std::size_t>(seen.safety.state);
  Json text;
  text["type"] = "state";
  text["cycle"] = seen.cycle;
  text["time"] = figure(static_cast<double>(seen.time_ns) * 1e-9);
  text["state"] = state < kStates ? Json(kStateNames[state]) : Json(nullptr);
  text["joints"] = jointsOf(seen);
  text["board"] = boardOf(seen.board);
  return written(text);
}

std::string loopText(const LoopFigures& figures, const Sensors& seen) {
  const runtime::StatsView &all = figures.all, &recent = figures.recent;
  constexpr double kMs = 1e-3;
  Json text;
  text["type"] = "loop";
  text["cycles"] = all.cycles;
  text["overruns"] = all.overruns;
  text["skipped"] = all.skipped;
  text["retries"] = all.retries;
  text["incomplete"] = all.incomplete;
  text["late_replies"] = all.late_replies;
  text["reconnects"] = all.reconnects;
  text["bad_checksums"] = seen.link.bad_checksums;
  text["garbage_bytes"] = seen.link.garbage_bytes;
  text["recent"] = {{"seconds", figure(figures.seconds, 1e3)},
                    {"cycles", recent.cycles},
                    {"overruns", recent.overruns},
                    {"skipped", recent.skipped},
                    {"retries", recent.retries},
                    {"incomplete", recent.incomplete},
                    {"wake_us", spread(recent.wake, 1)}};
  text["wake_us"] = spread(all.wake, 1);
  text["bus_ms"] = spread(all.bus, kMs);
  text["wire_ms"] = {{"p50", figure(all.wire.percentile(0.5) * kMs)}};
  text["slack_ms"] = {{"p1", figure(all.slack.percentile(0.01) * kMs)},
                      {"p50", figure(all.slack.percentile(0.5) * kMs)}};
  text["wake_histogram"] = histogramOf(all.wake);
  text["stale"] = runtime::staleDevices(seen);
  Json& hits = text["limit_hits"];
  for (std::size_t i = 0; i < kLimits; ++i) hits[std::string{kLimitNames[i]}] = seen.safety.limit_hits[i];
  text["driver"] = driverOf(figures.driver);
  text["session"] = figures.session;
  text["lost"] = figures.lost;
  return written(text);
}

std::string faultsText(const SafetyReport& safety) {
  Json active = Json::array();
  for (std::size_t i = 0; i < kFaults; ++i) {
    if (!safety.active[i]) continue;
    const FaultRow& row = kFaultTable[i];
    // Only of the worst one is it known which joint it concerns.
    const bool joint = row.fault == safety.worst && safety.worst_joint >= 1 && safety.worst_joint <= kJoints;
    active.push_back({{"code", static_cast<int>(row.fault)},
                      {"name", row.name},
                      {"joint", joint ? Json(kJointTable[safety.worst_joint - 1U].name) : Json(nullptr)},
                      {"meaning", row.meaning},
                      {"remedy", row.remedy}});
  }
  return written(Json{{"type", "faults"}, {"active", std::move(active)}});
}

std::string noticeText(std::uint64_t number, double time, const std::string& text) {
  return written(Json{{"type", "notice"}, {"number", number}, {"time", figure(time)}, {"text", text}});
}

std::string goneText(const std::string& reason) {
  return written(Json{{"type", "gone"}, {"reason", reason}});
}

std::string cameraText(bool seeing, const std::string& text) {
  return written(Json{{"type", "camera"}, {"seeing", seeing}, {"text", text}});
}

std::string errorText(const std::string& text) {
  return written(Json{{"type", "error"}, {"text", text}});
}

}  // namespace darwinop::monitor
