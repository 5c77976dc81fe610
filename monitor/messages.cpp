// Messages of the monitor channel, except "hello" and "loop".
#include "monitor/messages.hpp"

#include <utility>

#include "core/conversions.hpp"
#include "core/counts.hpp"
#include "core/joints.hpp"
#include "monitor/json.hpp"
#include "monitor/search_message.hpp"
#include "runtime/report.hpp"

namespace darwinop::monitor {
namespace {

constexpr double kPollStale = 3;  // s; every servo is polled within 1 s

Json ageOf(Freshness freshness) {
  return freshness.ever() ? Json(freshness.age) : Json(nullptr);
}

bool polledLately(const JointSensors& joint, double period) {
  return joint.polled.ever() && joint.polled.age * period <= kPollStale;
}

bool motionFresh(Freshness freshness) {
  return !freshness.stale();
}

/// Array with one value per joint.
template <class Value>
Json each(const Sensors& seen, Value value) {
  Json all = Json::array();
  for (const JointSensors& joint : seen.joint) all.push_back(value(joint));
  return all;
}

Json jointsOf(const Sensors& seen) {
  const double period = static_cast<double>(seen.period_ns) * 1e-9;
  const auto motion = [](double value, const JointSensors& j) {
    return motionFresh(j.motion) ? rounded(value) : nullptr;
  };
  const auto polled = [period](double value, const JointSensors& j) {
    return polledLately(j, period) ? rounded(value) : nullptr;
  };
  using J = const JointSensors&;
  Json joints;
  joints["position"] = each(seen, [&](J j) { return motion(j.position.value, j); });
  joints["goal"] = each(seen, [](J j) { return j.driven ? rounded(j.commanded.value) : nullptr; });
  joints["speed"] = each(seen, [&](J j) { return motion(j.velocity.value, j); });
  joints["load"] = each(seen, [&](J j) { return motion(j.load, j); });
  joints["age"] = each(seen, [](J j) { return ageOf(j.motion); });
  joints["driven"] = each(seen, [](J j) { return Json(j.driven); });
  Json silent = Json::array();
  for (std::size_t i = 0; i < kJoints; ++i) silent.push_back(seen.silent[i]);
  joints["silent"] = std::move(silent);
  joints["temperature"] = each(seen, [&](J j) { return polled(j.temperature.value, j); });
  joints["voltage"] = each(seen, [&](J j) { return polled(j.voltage.value, j); });
  joints["torque"] = each(seen, [&](J j) { return polledLately(j, period) ? Json(j.torque_enabled) : Json(nullptr); });
  joints["torque_limit"] = each(seen, [&](J j) { return polled(j.torque_limit.value, j); });
  joints["health_age"] = each(seen, [](J j) { return ageOf(j.polled); });
  return joints;
}

template <class Values>
Json axes(bool fresh, const Values& values) {
  Json all = Json::array();
  for (const auto& value : values) all.push_back(fresh ? rounded(value.value) : nullptr);
  return all;
}

template <class Values>
Json countsOf(bool fresh, const Values& values, const Register& law) {
  Json all = Json::array();
  for (const auto& value : values) all.push_back(fresh ? rounded(countFrom(value.value, law), 1) : nullptr);
  return all;
}

std::string colourText(std::uint16_t word) {
  char text[16];
  std::snprintf(text, sizeof text, "#%06x", static_cast<unsigned>(rgb24From15(word)) & 0xFFFFFFU);
  return text;
}

Json boardOf(const BoardSensors& board) {
  const bool fresh = motionFresh(board.motion);
  const auto known = [fresh](Json value) { return fresh ? std::move(value) : Json(nullptr); };
  Json text;
  text["absent"] = board.absent;
  text["age"] = ageOf(board.motion);
  text["accelerometer"] = axes(fresh, board.accelerometer);
  text["gyro"] = axes(fresh, board.gyro);
  text["accelerometer_count"] = countsOf(fresh, board.accelerometer, kAccelRegister);
  text["gyro_count"] = countsOf(fresh, board.gyro, kGyroRegister);
  text["mode_button"] = known((board.buttons & 1) != 0);
  text["start_button"] = known((board.buttons & 2) != 0);
  text["voltage"] = known(rounded(board.voltage.value));
  text["servo_power"] = known(board.servo_power);
  text["microphone"] = known(rounded(board.microphone_left));
  text["led"]["panel"] = known(board.led_panel);
  text["led"]["head"] = known(colourText(board.led_head));
  text["led"]["eye"] = known(colourText(board.led_eye));
  return text;
}

/// Reads one number; returns an error text or an empty string.
std::string take(const Json& request, const char* name, double most, double& into) {
  const auto found = request.find(name);
  if (found == request.end()) return {};
  const double value = found->is_number() ? found->get<double>() : kUnknown;
  if (!(value >= 0 && value <= most))
    return std::string{name} + " must be a number from 0 to " + std::to_string(static_cast<int>(most)) + ", in Hz";
  into = value;
  return {};
}

}  // namespace

std::optional<Subscription> parseSubscription(std::string_view text, const Subscription& before, std::string& why) {
  const Json request = Json::parse(text.begin(), text.end(), nullptr, false);
  Subscription subscription = before;
  why.clear();
  if (!request.is_object()) why = "the request must be a JSON object, such as {\"rate\": 20, \"camera\": 5}";
  if (why.empty()) why = take(request, "rate", kMostRate, subscription.rate);
  if (why.empty()) why = take(request, "camera", kMostPictures, subscription.camera);
  if (why.empty()) why = takeSearch(request, subscription);
  return why.empty() ? std::optional{subscription} : std::nullopt;
}

std::string stateText(const Sensors& seen) {
  const auto state = static_cast<std::size_t>(seen.safety.state);
  Json text;
  text["type"] = "state";
  text["cycle"] = seen.cycle;
  text["time"] = rounded(static_cast<double>(seen.time_ns) * 1e-9);
  text["state"] = state < kStates ? Json(kStateNames[state]) : Json(nullptr);
  text["joints"] = jointsOf(seen);
  text["board"] = boardOf(seen.board);
  return jsonText(text);
}

std::string faultsText(const SafetyReport& safety) {
  Json active = Json::array();
  for (std::size_t i = 0; i < kFaults; ++i) {
    if (!safety.active[i]) continue;
    const FaultRow& row = kFaultTable[i];
    // The joint is known only for the worst fault.
    const bool joint = row.fault == safety.worst && safety.worst_joint >= 1 && safety.worst_joint <= kJoints;
    active.push_back({{"code", static_cast<int>(row.fault)},
                      {"name", row.name},
                      {"joint", joint ? Json(kJointTable[safety.worst_joint - 1U].name) : Json(nullptr)},
                      {"meaning", row.meaning},
                      {"remedy", row.remedy}});
  }
  return jsonText(Json{{"type", "faults"}, {"active", std::move(active)}});
}

std::string noticeText(std::uint64_t number, double time, const std::string& text) {
  return jsonText(Json{{"type", "notice"}, {"number", number}, {"time", rounded(time)}, {"text", text}});
}

std::string goneText(const std::string& reason) {
  return jsonText(Json{{"type", "gone"}, {"reason", reason}});
}

std::string cameraText(bool seeing, const std::string& text) {
  return jsonText(Json{{"type", "camera"}, {"seeing", seeing}, {"text", text}});
}

std::string errorText(const std::string& text) {
  return jsonText(Json{{"type", "error"}, {"text", text}});
}

}  // namespace darwinop::monitor
