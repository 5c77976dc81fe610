// What a file of a whole robot does not hold is named.
#include "gap/export/body/body_holds.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <map>
#include <string>

#include "gap/export/body_rig.hpp"
#include "gap/export/texts.hpp"
#include "twin/effects/catalogue.hpp"
#include "twin/model/keys.hpp"

namespace darwinop::gap {
namespace {

using testing::Contains;
using testing::HasSubstr;

/// The text without blanks and comments, which name what is lost.
std::string withoutComments(std::string text, Target target) {
  const bool is_xml = target != Target::kWebots;
  const std::string begin = is_xml ? "<!--" : "#", end = is_xml ? "-->" : "\n";
  for (auto at = text.find(begin); at != text.npos; at = text.find(begin))
    text.erase(at, text.find(end, at) + end.size() - at);
  std::erase_if(text, [](char c) { return c == ' ' || c == '\n'; });
  return text;
}

/// Each change of `base` that a target does not name as lost changes what it writes.
void expectHeldOrLost(const std::string& base, const std::string& change, const std::string& named) {
  for (const TargetInfo& info : kTargetTable) {
    const Export before = exportBody(info.target, robotWith(base), {}),
                 after = exportBody(info.target, robotWith(base + change), {});
    const bool is_lost = std::ranges::any_of(
        after.lost, [&](const std::string& sentence) { return sentence.find("loses " + named) != sentence.npos; });
    if (is_lost) continue;
    EXPECT_NE(withoutComments(before.text, info.target), withoutComments(after.text, info.target))
        << info.title << ": " << named;
  }
}

TEST(BodyLosses, NameEachKeyThatChangesNothing) {
  const std::map<std::string, std::string> values{
      {"mass", "0.05 kg"},
      {"mass_from_com", "0.02, 0, 0 m"},
      {"com_shift", "0.01, 0, 0 m"},
      {"trunk_com", "manufacturer"},
      {"trunk_inertia", "published"},
      {"self_collision", "yes"},
      {"hold_until_driven", "yes"},
      {"floor_friction", "0.5"},
      {"contact_time", "0.02 s"},
      {"sole_size", "0.8"},
      {"floor_tilt_x", "0.04 rad"},
      {"floor_tilt_y", "0.04 rad"},
      {"battery_resistance", "0.2 ohm"},
      {"step", "0.002 s"},
      {"gyro_range", "10 rad/s"},
      {"accel_range", "20 m/s2"},
      {"gyro_bias", "0.1, 0, 0 rad/s"},
      {"accel_bias", "0.1, 0, 0 m/s2"},
      {"gyro_scale", "1.1, 1, 1"},
      {"accel_scale", "1.1, 1, 1"},
      {"mounting", "0.1, 0, 0 rad"},
      {"gyro_axes", "2, 1, 3"},
      {"accel_axes", "2, 1, 3"},
      {"gyro_lowpass", "0.01 s"},
      {"delay", "0.02 s"},
      {"gyro_noise", "0.01 rad/s"},
      {"accel_noise", "0.1 m/s2"},
  };
  for (const KeyHolding& holding : keyHoldings()) {
    const std::string key{holding.row.what};
    const std::string section = holding.section == "link" ? "link ArmLowerR" : std::string{holding.section};
    ASSERT_TRUE(values.contains(key)) << key;
    const std::string base = key == "mass_from_com" ? "[link ArmLowerR]\nmass = 0.05 kg\n" : "[" + section + "]\n";
    expectHeldOrLost(base, key + " = " + values.at(key) + "\n", "[" + section + "] " + key + " = ");
  }
}

TEST(BodyLosses, NameEachEffectThatChangesNothing) {
  for (const twin::EffectInfo* const info : twin::catalogue()) {
    if (info->id == "p_on_torque") continue;  // of the other law
    const std::string section = "[effect " + std::string{info->id} + " Neck]\n";
    std::string change = section;
    for (const twin::Parameter& one : info->parameters) {
      const double value = info->id == "torque_limit" && one.key == "torque"    ? 1   // none is typical
                           : info->id == "temp_drift" && one.key == "reference" ? 45  // not that of the export
                                                                                : one.typical;
      change += std::string{one.key} + " = " + shortest(value) + " " + std::string{one.unit} + "\n";
    }
    expectHeldOrLost(info->id == "coulomb" ? "" : "[effect coulomb]\nfriction = 0.06 N m\n", change,
                     std::string{info->id} + " (Neck)");
  }
}

TEST(BodyLosses, NameWhatIsNotHeldAndTheJointsOfAnEffect) {
  const Export made =
      exportBody(Target::kMujoco,
                 robotWith("[imu]\ndelay = 0.02 s\n[effect stribeck Neck]\nfriction = 0.05 N m\n"
                           "speed = 0.2 rad/s\nexponent = 1\n[effect backlash AnkleR]\nplay = 0.01 rad\n"),
                 {});
  EXPECT_THAT(made.lost, Contains(HasSubstr("MuJoCo loses [imu] delay = 0.02 s")));
  EXPECT_THAT(made.lost, Contains(HasSubstr("stribeck (Neck)")));
  EXPECT_THAT(made.lost, Contains(HasSubstr("backlash (AnkleR)")));
}

// A new key of a model file needs a row.
TEST(KeyHoldings, HaveARowForEachKeyOfLinksBodyAndSensors) {
  for (const twin::KeyRow& key : twin::keyTable()) {
    const std::string_view kind = key.section.substr(0, key.section.find(' '));
    if (kind == "model" || kind == "servo" || key.key == "xml") continue;
    const auto all = keyHoldings();
    EXPECT_TRUE(
        std::ranges::any_of(all, [&](const KeyHolding& row) { return row.section == kind && row.row.what == key.key; }))
        << kind << ' ' << key.key;
  }
}

}  // namespace
}  // namespace darwinop::gap
