// Motion files: all calls, no movement yet.
#include "webots/utils/Motion.hpp"

#include "webots/notices.hpp"

namespace webots {

Motion::Motion(const std::string& fileName) {
  darwinop::facade::warnOnce("Motion: this version cannot play motion files yet; " + fileName + " is skipped");
}

}  // namespace webots
