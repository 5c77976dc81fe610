// Example cases of another simulator, where they are there: what the first blocks show, against the answer key. The key
// is read by this test alone.
#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>

#include "gap/case/body/body_check.hpp"
#include "gap/identify/body/body_identification.hpp"
#include "support/shared_data.hpp"

namespace darwinop::gap {
namespace {

namespace fs = std::filesystem;

fs::path bodyExamples() {
  return sharedData("body-gap-cases");
}

/// Those of the effects that this version can name.
bool isOfSensor(const nlohmann::json& effect) {
  return std::ranges::any_of(sensorEffects(), [&](const SensorEffect& one) { return one.id == effect["id"]; });
}

TEST(BodyExamples, SensorEffectsAreNamedWithTheirNumbersAndNothingElseIs) {
  if (!fs::exists(bodyExamples())) GTEST_SKIP() << "no example cases in " << bodyExamples();
  const nlohmann::json key = nlohmann::json::parse(std::ifstream{bodyExamples() / "key.json"});
  ASSERT_EQ(key.size(), 14u);
  for (const auto& [name, truth] : key.items()) {
    const BodyCase c = readBodyCase((bodyExamples() / "cases" / name).string());
    EXPECT_THAT(checkData(c).warnings, testing::IsEmpty()) << name;
    const nlohmann::ordered_json answer = asJson(c, identify(c, BodyScope::kSensors));
    std::vector<std::string> expected, found;
    for (const auto& effect : truth["effects"])
      if (isOfSensor(effect)) expected.push_back(effect["id"]);
    for (const auto& effect : answer["effects"]) found.push_back(effect["id"]);
    EXPECT_EQ(found, expected) << name;
    for (const auto& effect : truth["effects"]) {
      if (!isOfSensor(effect)) continue;
      for (const auto& [parameter, values] : effect["params"].items())
        for (std::size_t axis = 0; axis < 3; ++axis)
          EXPECT_NEAR(answer["effects"][0]["params"][parameter][axis].get<double>(), values[axis].get<double>(), 0.01)
              << name << " " << parameter << " " << axis;
    }
  }
}

TEST(BodyExamples, ADutyLimitOfAPairIsLocalizedInThatPair) {
  if (!fs::exists(bodyExamples())) GTEST_SKIP() << "no example cases in " << bodyExamples();
  const BodyCase c = readBodyCase((bodyExamples() / "cases/x10").string());
  const BodyTable table = localize(c, RestingImu{c.joints.model});
  ASSERT_EQ(table.open(), 2u);
  EXPECT_THAT((std::vector{table.rows[0].place.name, table.rows[1].place.name}),
              testing::UnorderedElementsAre("LegUpperR", "LegUpperL"));
}

}  // namespace
}  // namespace darwinop::gap
