// Table of servo models.
#include "core/servo_models.hpp"

#include <gtest/gtest.h>

#include <set>

namespace darwinop {
namespace {

TEST(ServoModels, ANumberAndANameIsOneModel) {
  std::set<int> numbers;
  std::set<std::string_view> names;
  for (const ServoModel& model : kServoModels) {
    EXPECT_TRUE(numbers.insert(model.number).second) << model.name;
    EXPECT_TRUE(names.insert(model.name).second) << model.name;
    EXPECT_EQ(findServoModel(model.number), &model);
  }
  EXPECT_EQ(findServoModel(12), nullptr);
}

TEST(ServoModels, OnlyAnMx28IsDrivenWithoutASettingAndNothingPermitsOtherRegisters) {
  for (const ServoModel& model : kServoModels) {
    EXPECT_EQ(isDriven(model, {}), model.name == "MX-28") << model.name;
    EXPECT_EQ(isDriven(model, ServoModels{}.set()), !model.name.ends_with("(2.0)")) << model.name;
  }
}

}  // namespace
}  // namespace darwinop
