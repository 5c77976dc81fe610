// Every effect of a whole robot, wherever it is: found, added to the model file and read back, it gives the twin that
// moves as the simulation by which it was found. A new effect without a key fails here.
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "gap/benchmark/body/body_effects.hpp"
#include "gap/plant/body/model_with.hpp"
#include "gap/report/body/body_additions.hpp"
#include "gap/report/calm_motion.hpp"
#include "support/text_of.hpp"
#include "twin/effects/catalogue.hpp"
#include "twin/model/keys.hpp"

namespace darwinop::gap {
namespace {

using nlohmann::json;

constexpr double kFrictionNoise = 1e-5;  // rad: what the sixth digit of a number makes of a joint that sticks

std::string shippedText() {
  return textOf(twin::findModel("darwin-op"));
}

/// Where recordings show it without contacts.
BodySetup setupFor(const BodyEffect& effect, const BodyKey& key) {
  const bool is_on_floor = effect.kind == BodyClass::kSensor || effect.kind == BodyClass::kContact ||
                           key.effects.front().at.front() == "Body";
  return is_on_floor ? BodySetup::kFloor : BodySetup::kClamped;
}

struct PlacedName {
  BodyEffect effect;
  std::uint64_t seed;
};
std::ostream& operator<<(std::ostream& out, const PlacedName& name) {
  return out << name.effect.id << '@' << static_cast<int>(name.effect.kind);
}

std::vector<PlacedName> allOfTheCatalogue() {
  std::vector<PlacedName> out;
  std::uint64_t seed = 1;
  for (const BodyEffect& effect : bodyEffects())
    if (effect.kind != BodyClass::kOutside) out.push_back({effect, ++seed});
  return out;
}

/// As `gap run` writes it.
json answerOf(const BodyKey& key) {
  json effects = json::array();
  for (const BodyKeyEffect& effect : key.effects) {
    json params = json::object();
    for (const auto& [name, values] : effect.values)
      params[name] = values.size() == 1 ? json(values.front()) : json(values);
    // Goals of all joints that act later have two names.
    const std::string id = effect.id == "bus_latency" ? "transport_delay" : effect.id;
    effects.push_back(
        {{"id", id}, {"at", effect.at.size() == 1 ? json(effect.at.front()) : json(effect.at)}, {"params", params}});
  }
  return {{"case", "c"}, {"verdict", "named"}, {"effects", effects}};
}

/// Values of an effect in one joint; empty: it does not have it.
std::vector<double> valuesAt(const twin::Model& model, const twin::EffectInfo* info, Joint joint) {
  std::vector<double> values;
  for (const twin::EffectSetting& effect : model.effects)
    if (effect.info == info && (effect.joint == joint || (!effect.joint && values.empty()))) values = effect.values;
  return values;
}

/// But for the sixth digit.
void expectNear(double is, double wanted, std::string_view what) {
  EXPECT_TRUE(is == wanted || std::abs(is - wanted) <= 1e-5 * std::abs(wanted)) << what << ": " << is << ' ' << wanted;
}

void expectSame(twin::Model is, twin::Model wanted) {
  for (const twin::KeyRow& row : twin::keyTable()) {
    const twin::Slot slot = row.in(is), other = row.in(wanted);
    if (auto* const* const number = std::get_if<double*>(&slot))
      expectNear(**number, **std::get_if<double*>(&other), row.key);
    else if (auto* const* const axes = std::get_if<std::array<double, 3>*>(&slot))
      for (std::size_t i = 0; i < 3; ++i)
        expectNear((**axes)[i], (**std::get_if<std::array<double, 3>*>(&other))[i], row.key);
  }
  for (const twin::EffectInfo* const info : twin::catalogue())
    for (std::size_t i = 0; i < kJoints; ++i) {
      const auto a = valuesAt(is, info, static_cast<Joint>(i)), b = valuesAt(wanted, info, static_cast<Joint>(i));
      ASSERT_EQ(a.size(), b.size()) << info->id << ' ' << kJointTable[i].name;
      for (std::size_t k = 0; k < a.size(); ++k) expectNear(a[k], b[k], info->id);
    }
}

class EveryEffect : public testing::TestWithParam<PlacedName> {};

TEST_P(EveryEffect, OfAWholeRobotIsAddedAndTheTwinMovesByIt) {
  const twin::Model model = twin::readModel(twin::findModel("darwin-op"));
  Rng rng{GetParam().seed};
  BodyTruth truth;
  truth.model = unchangedRobot(model).model;
  BodyKey key;
  hide(GetParam().effect, recordingOf(model, BodySetup::kFloor), rng, truth, key);

  const json answer = answerOf(key);
  const BodyAdditions added = bodyAdditionsIn(answer.dump(), "report.json", "c", model);
  EXPECT_THAT(added.left_out, testing::IsEmpty());
  twin::Model repaired = twin::parseModel(withAdditions(shippedText(), added.additions), "repaired.ini");
  repaired.folder = model.folder;

  if (truth.battery_ohm > 0) {  // gap takes the measured voltage: it simulates no battery
    EXPECT_NEAR(repaired.body.battery_resistance_ohm, truth.battery_ohm, 1e-6);
    return;
  }
  FloorModel hypothesis = truth.model;
  if (GetParam().effect.kind == BodyClass::kAll || GetParam().effect.kind == BodyClass::kBus ||
      GetParam().effect.kind == BodyClass::kMass) {
    // A key has one number for all joints, also where the model's own differ, and no place of a mass in its link.
    AnsweredRobot robot = unchangedRobot(model);
    for (const json& effect : answer["effects"]) addEffect(robot, effect, model);
    hypothesis = robot.model;
  }
  const Plain& plain = plainIn(setupFor(GetParam().effect, key));
  const Signals wanted = simulatedByGap(plain.given, hypothesis), made = recordedFromTwin(repaired, plain.given);
  const Eigen::VectorXd size = rmsOf(wanted - plain.signals), wrong = rmsOf(made - wanted);
  for (Eigen::Index i = 0; i < size.size(); ++i)
    EXPECT_LT(wrong[i], 0.25 * size.maxCoeff() + 10 * plain.noise[i])
        << floorSignal(static_cast<std::size_t>(i)) << ", effect " << size[i] << ", noise " << plain.noise[i];

  // Small effects disappear in the difference of two integrators: the twin against itself, with all digits.
  const twin::Model found = modelWith(model, hypothesis.robot, hypothesis.imu).model;
  expectSame(repaired, found);
  const bool is_chaotic = !isClamped(plain.given) && GetParam().effect.kind != BodyClass::kSensor;
  const Eigen::VectorXd noise =
      is_chaotic ? plain.noise : Eigen::VectorXd{kFrictionNoise * Eigen::VectorXd::Ones(size.size())};
  const Signals exact = recordedFromTwin(found, plain.given);
  const Eigen::VectorXd own = rmsOf(exact - plain.of_twin), rounded = rmsOf(made - exact);
  EXPECT_GT((own.array() / noise.array()).maxCoeff(), 1) << "this motion does not show it";
  for (Eigen::Index i = 0; i < own.size(); ++i)
    EXPECT_LT(rounded[i], 0.05 * own.maxCoeff() + 5 * noise[i]) << floorSignal(static_cast<std::size_t>(i));
}

INSTANTIATE_TEST_SUITE_P(Catalogue, EveryEffect, testing::ValuesIn(allOfTheCatalogue()), [](const auto& named) {
  return named.param.effect.id + "_" + std::to_string(static_cast<int>(named.param.effect.kind));
});

TEST(TwinOfTheModel, WithoutAnyEffectMovesAsGapSimulatesIt) {
  const Eigen::VectorXd in_stand = plainIn(BodySetup::kClamped).noise, on_floor = plainIn(BodySetup::kFloor).noise;
  EXPECT_LT(in_stand.maxCoeff(), 2e-3);
  EXPECT_LT(on_floor.head(kJoints).maxCoeff(), 1e-3);
  EXPECT_LT(on_floor.segment(kJoints, 3).maxCoeff(), 0.01);
  EXPECT_LT(on_floor.tail(3).maxCoeff(), 0.1);
}

}  // namespace
}  // namespace darwinop::gap
