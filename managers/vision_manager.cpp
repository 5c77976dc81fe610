// Implements the upstream vision manager API with the colour finder. Throws no exceptions to the controller.
#include <algorithm>
#include <optional>
#include <stdexcept>
#include <string>

#include "DARwInOPVisionManager.hpp"
#include "managers/vision/colour_finder.hpp"
#include "webots/notices.hpp"

namespace managers {

using darwinop::webots_api::warnOnce;
namespace vision = darwinop::vision;

namespace {

/// Warns once per parameter, because a controller may sweep one.
int adjusted(const std::string& what, const char* range, int value, int valid) {
  if (value != valid) warnOnce("VisionManager: " + what + " is out of range and was adjusted to " + range);
  return valid;
}

/// Wraps the angle.
int hueInRange(int hue) {
  if (hue >= 0 && hue <= 360) return hue;
  return adjusted("hue", "0 to 360: the same direction", hue, (hue % 360 + 360) % 360);
}

int toleranceInRange(int tolerance) {
  return adjusted("hue tolerance", "0 to 180", tolerance, std::clamp(tolerance, 0, 180));
}

/// -1 also accepts colours without saturation or value; smaller numbers are equivalent.
int minimumInRange(const std::string& what, int minimum) {
  return adjusted(what, "-1 to 100", minimum, std::clamp(minimum, -1, 100));
}

int percentInRange(const std::string& what, int percent) {
  return adjusted(what, "0 to 100", percent, std::clamp(percent, 0, 100));
}

}  // namespace

struct DARwInOPVisionManager::Impl {
  std::optional<vision::ColourFinder> finder;  // empty for an invalid image size: nothing is found
  vision::Thresholds thresholds;
  vision::PercentLimits limits;

  void apply() {
    if (!finder) return;
    finder->setThresholds(thresholds);
    finder->setLimits(limits);
  }
};

DARwInOPVisionManager::DARwInOPVisionManager(int width, int height, int hue, int hue_tolerance, int min_saturation,
                                             int min_value, int min_percent, int max_percent)
    : impl_{new Impl} {
  try {
    impl_->finder.emplace(width, height, impl_->thresholds);
  } catch (const std::exception& why) {
    warnOnce(std::string{"VisionManager: "} + why.what() + "; nothing will be found");
  }
  setHue(hue);
  setHueTolerance(hue_tolerance);
  setMinSaturation(min_saturation);
  setMinValue(min_value);
  setMinPercent(min_percent);
  setmaxPercent(max_percent);
}

DARwInOPVisionManager::DARwInOPVisionManager(const DARwInOPVisionManager& other) : impl_{new Impl{*other.impl_}} {}

DARwInOPVisionManager& DARwInOPVisionManager::operator=(const DARwInOPVisionManager& other) {
  if (this != &other) *impl_ = *other.impl_;
  return *this;
}

DARwInOPVisionManager::~DARwInOPVisionManager() {
  delete impl_;
}

bool DARwInOPVisionManager::getBallCenter(double& x, double& y, const unsigned char* image) {
  x = y = 0;
  if (image == nullptr) warnOnce("VisionManager: the image of getBallCenter() is null; enable the camera");
  if (!impl_->finder) return false;
  vision::ColourFinder& finder = *impl_->finder;
  const std::size_t bytes = 4 * static_cast<std::size_t>(finder.width()) * static_cast<std::size_t>(finder.height());
  const auto centre = image == nullptr ? finder.find({}) : finder.find({image, bytes});
  if (!centre) return false;
  x = centre->x;
  y = centre->y;
  return true;
}

bool DARwInOPVisionManager::isDetected(int x, int y) {
  return impl_->finder && impl_->finder->isDetected(x, y);
}

void DARwInOPVisionManager::setHue(int hue) {
  impl_->thresholds.hue = hueInRange(hue);
  impl_->apply();
}

void DARwInOPVisionManager::setHueTolerance(int hue_tolerance) {
  impl_->thresholds.hue_tolerance = toleranceInRange(hue_tolerance);
  impl_->apply();
}

void DARwInOPVisionManager::setMinSaturation(int min_saturation) {
  impl_->thresholds.min_saturation = minimumInRange("minimum saturation", min_saturation);
  impl_->apply();
}

void DARwInOPVisionManager::setMinValue(int min_value) {
  impl_->thresholds.min_value = minimumInRange("minimum value", min_value);
  impl_->apply();
}

void DARwInOPVisionManager::setMinPercent(int min_percent) {
  impl_->limits.min = percentInRange("minimum percent", min_percent);
  impl_->apply();
}

void DARwInOPVisionManager::setmaxPercent(int max_percent) {
  impl_->limits.max = percentInRange("maximum percent", max_percent);
  impl_->apply();
}

}  // namespace managers
