// DARwInOPVisionManager under its newer name.
#ifndef ROBOTIS_OP2_VISION_MANAGER_HPP
#define ROBOTIS_OP2_VISION_MANAGER_HPP

#include <DARwInOPVisionManager.hpp>

namespace managers {

/// All methods are those of DARwInOPVisionManager.
class RobotisOp2VisionManager : public DARwInOPVisionManager {
 public:
  /// Same as DARwInOPVisionManager(): pixels, degrees and percent.
  RobotisOp2VisionManager(int width, int height, int hue, int hueTolerance, int minSaturation, int minValue,
                          int minPercent, int maxPercent)
      : DARwInOPVisionManager(width, height, hue, hueTolerance, minSaturation, minValue, minPercent, maxPercent) {}
};

}  // namespace managers

#endif
