// Every effect of a whole robot, wherever it is: found, added to the model file and read back, it gives the twin that
// moves as the simulation by which it was found. A new effect without a key fails here.
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "gap/benchmark/body/body_effects.hpp"
#include "gap/identify/body/answer_model.hpp"
#include "gap/plant/body/limb_parts.hpp"
#include "gap/plant/body/model_with.hpp"
#include "gap/report/body/body_additions.hpp"
#include "support/text_of.hpp"
#include "twin/body/robot_body.hpp"
#include "twin/effects/catalogue.hpp"
#include "twin/model/keys.hpp"

namespace darwinop::gap {
namespace {

using nlohmann::json;

constexpr double kBatteryVolt = 11.8;
constexpr int kRows = 32;
constexpr double kFrictionNoise = 1e-5;       // rad: what the sixth digit of a number makes of a joint that sticks
constexpr Axes kUpwards{0.48, 0.8, 0.36};     // gravity turns all joints
constexpr double kFinestTicks = 4096 * 1024;  // as gap/plant/body/limb_parts.cpp: an encoder without steps

std::string shippedText() {
  return textOf(twin::findModel("darwin-op"));
}

double sideOf(Joint joint) {
  return index(joint) % 2 == 0 ? 1 : -1;
}

/// On the floor, from straight legs, whose soles are level: the trunk pitches, rolls and turns so calmly that the feet
/// stay.
double goalOnFloor(Joint joint, double time_s) {
  const double wave = std::sin(6 * time_s);
  switch (joint) {
    case Joint::kLegUpperR:
    case Joint::kLegUpperL:
      return sideOf(joint) * 0.15 * wave;
    case Joint::kPelvR:
    case Joint::kPelvL:
      return 0.03 * wave;
    case Joint::kFootR:
    case Joint::kFootL:
      return -0.03 * wave;
    case Joint::kPelvYR:
    case Joint::kPelvYL:
      return 0.03 * wave;
    default:
      return 0;
  }
}

/// In a stand: all joints swing.
double goalInStand(Joint joint, double time_s) {
  return (sideOf(joint) > 0 ? 0.4 : -0.3) * std::sin(9 * time_s);
}

BodyCase recordingOf(const twin::Model& model, BodySetup setup) {
  BodyCase out;
  out.name = "c";
  out.joints.model = model;
  BodyLog log;
  log.file = "log.csv", log.setup = setup, log.battery_v = kBatteryVolt;
  if (setup == BodySetup::kClamped) log.up = kUpwards;
  for (int row = 0; row < kRows; ++row) log.time_s.push_back(0.016 * row);
  for (std::size_t i = 0; i < kJoints; ++i) {
    Trajectory of;
    of.joint = static_cast<Joint>(i), of.time_s = log.time_s, of.supply_v = kBatteryVolt;
    for (const double time : log.time_s)
      of.goal_rad.push_back((setup == BodySetup::kClamped ? goalInStand : goalOnFloor)(static_cast<Joint>(i), time));
    of.torque_on.assign(kRows, 1);
    of.p_register_of_row.assign(kRows, 32);
    for (auto* column : {&of.position_rad, &of.load, &of.speed_rad_s, &of.volt_v, &of.temp_c})
      column->assign(kRows, std::nan(""));
    out.joints.logs.push_back(std::move(of));
  }
  out.logs.push_back(std::move(log));
  return out;
}

bool isClamped(const BodyCase& given) {
  return given.logs.front().setup == BodySetup::kClamped;
}

/// Signals of a recording: rows x (joints, gyroscope, accelerometer).
using Signals = Eigen::MatrixXd;

Signals simulatedByGap(const BodyCase& given, const FloorModel& robot) {
  if (isClamped(given)) {  // limb by limb; positions alone
    Signals out = Signals::Zero(kRows, kJoints);
    for (const Limb& limb : limbsOf(given.joints.model)) {
      const LimbTrace trace = rollOut(given, 0, limb, robot.robot.robot);
      for (std::size_t i = 0; i < limb.size(); ++i)
        out.col(static_cast<Eigen::Index>(limb[i].joint)) = trace.position_rad.col(static_cast<Eigen::Index>(i));
    }
    return out;
  }
  const FloorTrace trace = rollOut(given, 0, robot.robot);
  const MovingImu::Readings sensed = MovingImu{given.joints.model}.of(trace, robot.imu);
  Signals out(kRows, kJoints + 6);
  out << trace.position_rad, sensed.gyro_rad_s, sensed.accel_m_s2;
  return out;
}

/// The same recording of the twin with a model file: `--robot twin:FILE` without bus and registers.
Signals recordedFromTwin(twin::Model model, const BodyCase& given) {
  model.servo.ticks_per_rev = kFinestTicks;
  twin::RobotBodyOptions options{.ball = twin::Ball::kNone};
  if (isClamped(given)) options.clamped_up = kUpwards;
  twin::RobotBody body{model, options};
  std::array<double, kJoints> pose{};
  body.place(pose);
  Drives drives{};
  for (ServoDrive& drive : drives) drive.supply_v = kBatteryVolt;
  constexpr Nanos kCycle{1'000'000};
  constexpr int kRowCycles = 16;
  const int held_cycles = isClamped(given) ? 1000 : 1500;
  Signals out(kRows, kJoints + 6);
  for (int row = 0; row < kRows; ++row) {
    const auto write = [&](std::size_t of) {
      for (std::size_t i = 0; i < kJoints; ++i) takeRow(given.joint(0, i), of, drives[i]);
    };
    write(static_cast<std::size_t>(std::max(0, row - 1)));
    for (int cycle = 0; cycle < (row == 0 ? held_cycles : kRowCycles); ++cycle) body.step(kCycle, drives);
    const BodyState& state = body.state();
    for (std::size_t i = 0; i < kJoints; ++i) out(row, static_cast<Eigen::Index>(i)) = state.joint[i].position_rad;
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      out(row, kJoints + axis) = state.gyro_rad_s[static_cast<std::size_t>(axis)];
      out(row, kJoints + 3 + axis) = state.accel_m_s2[static_cast<std::size_t>(axis)];
    }
  }
  return isClamped(given) ? Signals{out.leftCols(kJoints)} : out;
}

/// Of each signal.
Eigen::VectorXd rmsOf(const Signals& errors) {
  return (errors.cwiseAbs2().colwise().mean()).cwiseSqrt().transpose();
}

/// A robot without effects, and by what the twin and gap's simulation of it differ: another integrator in a stand; on
/// the floor contacts and dry friction amplify rounding errors, as six digits of a model file are.
struct Plain {
  BodyCase given;
  Signals signals, of_twin;
  Eigen::VectorXd noise;

  explicit Plain(BodySetup setup)
      : given{recordingOf(twin::readModel(twin::findModel("darwin-op")), setup)},
        signals{simulatedByGap(given, unchangedRobot(given.joints.model).model)},
        of_twin{recordedFromTwin(given.joints.model, given)},
        noise{rmsOf(of_twin - signals)} {
    for (const double drop_m : {1e-8, 2e-8, 1e-13}) {
      FloorModel dropped = unchangedRobot(given.joints.model).model;
      dropped.robot.engine.drop_m = drop_m;
      if (!isClamped(given)) noise = noise.cwiseMax(rmsOf(simulatedByGap(given, dropped) - signals));
    }
  }
};
const Plain& plainIn(BodySetup setup) {
  static const Plain kInStand{BodySetup::kClamped}, kOnFloor{BodySetup::kFloor};
  return setup == BodySetup::kClamped ? kInStand : kOnFloor;
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
      if (!name.ends_with("_added")) params[name] = values.size() == 1 ? json(values.front()) : json(values);
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
