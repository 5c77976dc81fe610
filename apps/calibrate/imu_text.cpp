#include "apps/calibrate/imu_text.hpp"

#include <algorithm>
#include <iterator>

#include "connect/imu_keys.hpp"
#include "core/text/formatted.hpp"
#include "core/text/number_text.hpp"

namespace darwinop::calibrate {

using text::formatted;

namespace {

constexpr int kDecimals = 5;

std::string three(const Axes& values) {
  std::string out;
  for (const double value : values) out += (out.empty() ? "" : ", ") + text::fixedText(value, kDecimals);
  return out;
}

double worst(const ImuFit& fit, double PostureError::*of) {
  double most = 0;
  for (const PostureError& error : fit.errors) most = std::max(most, error.*of);
  return most;
}

}  // namespace

std::string asText(const ImuFit& fit, const cm730::ImuCalibration& before) {
  std::string out = "\nError of the direction of up, deg:\n";
  out += formatted("  %-12s %8s %8s %22s\n", "posture", "before", "after", "fitted to the others");
  for (const PostureError& error : fit.errors)
    out += formatted("  %-12s %8.2f %8.2f %22s\n", std::string{error.posture->name}.c_str(), error.before_deg,
                     error.after_deg,
                     error.predicted_deg >= 0 ? text::fixedText(error.predicted_deg, 2).c_str() : "not known");
  out += formatted("\n  %-12s %-30s %-30s %s\n", "[Imu]", "before", "after", "standard deviation");
  for (const connect::ImuKey& key : connect::kImuKeys)
    out += formatted("  %-12s %-30s %-30s %s %s\n", std::string{key.name}.c_str(), three(before.*key.axes).c_str(),
                     three(fit.calibration.*key.axes).c_str(), three(fit.sigma.*key.axes).c_str(),
                     std::string{key.unit}.c_str());
  return out;
}

std::vector<IniValue> iniValues(const ImuFit& fit, const std::string& date) {
  std::vector<IniValue> out;
  out.reserve(std::size(connect::kImuKeys));
  for (const connect::ImuKey& key : connect::kImuKeys)
    out.push_back(
        {std::string{key.name}, three(fit.calibration.*key.axes),
         date + ", sd " + three(fit.sigma.*key.axes) + (key.unit.empty() ? "" : " " + std::string{key.unit})});
  out.back().comment += formatted("; %zu postures, up to %.2f deg off before, %.2f after", fit.errors.size(),
                                  worst(fit, &PostureError::before_deg), worst(fit, &PostureError::after_deg));
  return out;
}

}  // namespace darwinop::calibrate
