#include "gap/identify/body/held_out_text.hpp"

#include <cmath>

#include "core/text/formatted.hpp"

namespace darwinop::gap {

std::string asText(const HeldOutGap& gap) {
  std::string text;
  const auto add = [&](const char* what, double GapErrors::*of, double factor, const char* unit) {
    if (!std::isfinite(gap.before.*of) && !std::isfinite(gap.after.*of)) return;
    const auto shown = [&](const GapErrors& errors) {
      return std::isfinite(errors.*of) ? text::formatted("%.3g", factor * (errors.*of)) : std::string{"not known"};
    };
    text += std::string{text.empty() ? " " : ", "} + what + " " + shown(gap.before) + " -> " + shown(gap.after) + " " +
            unit + " (noise " + shown(gap.floor) + ")";
  };
  add("joints", &GapErrors::joints, 1e3, "mrad");
  add("gyro", &GapErrors::gyro, 1, "rad/s");
  add("accelerometer", &GapErrors::accel, 1, "m/s2");
  return text.empty() ? text : "  held-out logs that are simulated:" + text + "\n";
}

nlohmann::ordered_json asJson(const GapErrors& of) {
  const auto known = [](double value) {
    return std::isfinite(value) ? nlohmann::ordered_json(value) : nlohmann::ordered_json(nullptr);
  };
  return {{"joints_mrad", known(1e3 * of.joints)}, {"gyro_rad_s", known(of.gyro)}, {"accel_m_s2", known(of.accel)}};
}

}  // namespace darwinop::gap
