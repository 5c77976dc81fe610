#include "window/live/live_message.hpp"

#include <cmath>
#include <nlohmann/json.hpp>
#include <span>

#include "core/json/json_text.hpp"
#include "gap/live/thresholds.hpp"
#include "window/messages.hpp"

namespace darwinop::window {
namespace {

using Json = nlohmann::ordered_json;
using gap::live::LiveReport;
using gap::live::SignalResidual;
using gap::live::Support;

constexpr std::size_t kLongestModel = 1000;  // bytes
constexpr std::array<std::string_view, 2> kSupports{"clamped", "floor"};

std::string_view nameOf(Support support) {
  return kSupports.at(static_cast<std::size_t>(support));
}

Json orNull(double value) {
  return std::isfinite(value) ? Json(value) : Json(nullptr);
}

/// rms, worst and newest of some signals, in this unit.
Json residualsOf(std::span<const SignalResidual> signals, double per_unit) {
  Json rms = Json::array(), worst = rms, newest = rms;
  for (const SignalResidual& signal : signals) {
    rms.push_back(orNull(signal.rms * per_unit));
    worst.push_back(orNull(signal.worst * per_unit));
    newest.push_back(orNull(signal.newest * per_unit));
  }
  return {{"rms", std::move(rms)}, {"worst", std::move(worst)}, {"newest", std::move(newest)}};
}

constexpr double kMradPerRad = 1e3, kPercent = 100;

Json signalsOf(const LiveReport& report) {
  return {{"position_mrad", residualsOf(report.position_rad, kMradPerRad)},
          {"load_percent", residualsOf(report.load, kPercent)},
          {"gyro_rad_s", residualsOf(report.gyro_rad_s, 1)},
          {"accelerometer_m_s2", residualsOf(report.accel_m_s2, 1)}};
}

Json settingOf(const LiveSetting& setting) {
  return {{"model", setting.model}, {"support", nameOf(setting.support)}};
}

Json resyncsOf(const LiveReport& report) {
  Json out = Json::object();
  for (std::size_t i = 0; i < gap::live::kResyncs; ++i)
    out[std::string{name(static_cast<gap::live::Resync>(i))}] = report.resyncs[i];
  return out;
}

Json flagsOf(const std::bitset<kJoints>& flags) {
  Json out = Json::array();
  for (std::size_t i = 0; i < kJoints; ++i) out.push_back(flags[i]);
  return out;
}

std::string takeSetting(const Json& value, LiveSetting& setting) {
  for (const auto& [member, given] : value.items()) {
    const std::string* const text = given.is_string() ? given.get_ptr<const std::string*>() : nullptr;
    if (member == "model" && text != nullptr && !text->empty() && text->size() <= kLongestModel) {
      setting.model = *text;
    } else if (member == "support" && text != nullptr && *text == nameOf(Support::kClamped)) {
      setting.support = Support::kClamped;
    } else if (member == "support" && text != nullptr && *text == nameOf(Support::kFloor)) {
      setting.support = Support::kFloor;
    } else {
      return messages::kInvalidLiveRequest;
    }
  }
  return setting.model.empty() ? messages::kInvalidLiveRequest : "";
}

}  // namespace

std::optional<LiveRequest> parseLiveRequest(std::string_view text, std::string& why) {
  const Json message = Json::parse(text.begin(), text.end(), nullptr, false);
  why = messages::kInvalidLiveRequest;
  if (!message.is_object() || message.size() != 1 || !message.contains("run")) return std::nullopt;
  const Json& run = message["run"];
  if (run.is_null()) return LiveRequest{};
  if (!run.is_object()) return std::nullopt;
  LiveSetting setting;
  why = takeSetting(run, setting);
  return why.empty() ? std::optional{LiveRequest{setting}} : std::nullopt;
}

std::string liveText(const LiveStatus& status) {
  const LiveReport& report = status.report;
  Json out{{"type", "comparison"},
           {"runs", status.runs},
           {"setting", settingOf(status.setting)},
           {"error", status.error.empty() ? report.error : status.error},
           {"no_robot", status.no_robot},
           {"state", name(report.state)},
           {"resynced", report.resynced ? Json(name(*report.resynced)) : Json(nullptr)},
           {"resyncs", resyncsOf(report)},
           {"up", report.up ? Json(*report.up) : Json(nullptr)},
           {"cycles", report.cycles},
           {"compared", report.compared},
           {"missing", report.missing},
           {"dropped", status.dropped},
           {"gains_known", report.are_gains_known},
           {"step_ms", status.step_s > 0 ? Json(status.step_s * 1e3) : Json(nullptr)},
           {"period_ms", status.period_s > 0 ? Json(status.period_s * 1e3) : Json(nullptr)},
           {"window_s", gap::live::kWindow},
           {"driven", flagsOf(report.driven)},
           {"silent", flagsOf(report.silent)},
           {"signals", signalsOf(report)},
           {"before", nullptr}};
  if (status.before) {
    out["before"] = settingOf(*status.setting_before);
    out["before"]["signals"] = signalsOf(*status.before);
  }
  return jsonText(out);
}

}  // namespace darwinop::window
