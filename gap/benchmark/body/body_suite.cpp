#include "gap/benchmark/body/body_suite.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <mutex>
#include <numeric>
#include <sstream>
#include <stdexcept>

#include "gap/benchmark/body/given_effects.hpp"
#include "gap/benchmark/body/write_body_case.hpp"
#include "gap/localize/body/drawn_robot.hpp"
#include "gap/parallel/parallel.hpp"
#include "gap/plant/body/joint_alone.hpp"

namespace darwinop::gap {
namespace {

constexpr std::size_t kPairCases = 12, kEffectFreeCases = 16, kOutsideCases = 9;

/// What an owner knows of a robot: relative, or in the unit of the key.
const std::map<std::string, double, std::less<>> kTrust{
    {"body.mass", 0.03},          {"body.com_m", 0.002},   {"servo", 0.03},
    {"servo.duty_per_kp", 0.01},  {"servo.armature", 0.1}, {"friction", 0.2},
    {"floor_friction", 0.15},     {"contact_time", 0.2},   {"imu.gyro_bias_rad_s", 0.03},
    {"imu.accel_bias_m_s2", 0.05}};

using BodyRequests = std::vector<BodyRequest>;

std::vector<BodyEffect> ofKind(BodyClass kind) {
  std::vector<BodyEffect> out;
  std::ranges::copy_if(bodyEffects(), std::back_inserter(out), [&](const BodyEffect& one) { return one.kind == kind; });
  return out;
}

void addQuick(Rng& rng, BodyRequests& all) {
  constexpr std::array kKinds{BodyClass::kSensor,  BodyClass::kSensor,  BodyClass::kMass,
                              BodyClass::kContact, BodyClass::kContact, BodyClass::kOneJoint,
                              BodyClass::kPair,    BodyClass::kAll,     BodyClass::kBus};
  for (const BodyClass kind : kKinds) all.push_back({.effects = {rng.pick(ofKind(kind))}});
  all.push_back({.effects = {}});
  all.push_back({.effects = {}, .wrong_numbers = true});
  all.push_back({.effects = {rng.pick(ofKind(BodyClass::kOutside))}});
}

void addSingles(Rng& rng, BodyRequests& all) {
  for (const BodyEffect& effect : bodyEffects())
    if (effect.kind != BodyClass::kOutside) all.push_back({.effects = {effect}, .wrong_numbers = rng.uniform() < 0.25});
}

/// Two effects of different kinds.
void addPairs(Rng& rng, BodyRequests& all) {
  constexpr std::array kKinds{BodyClass::kSensor, BodyClass::kMass, BodyClass::kContact, BodyClass::kOneJoint,
                              BodyClass::kPair};
  for (std::size_t i = 0; i < kPairCases;) {
    const BodyClass a = rng.pick(kKinds), b = rng.pick(kKinds);
    if (a == b) continue;
    all.push_back({.effects = {rng.pick(ofKind(a)), rng.pick(ofKind(b))}});
    ++i;
  }
}

BodyRequests named(BodyRequests all, Rng& rng) {
  for (std::size_t i = 0; i < all.size(); ++i) {
    const std::string number = std::to_string(i + 1);
    all[i].name = "b" + std::string(number.size() < 3 ? 3 - number.size() : 0, '0') + number;
    all[i].seed = rng.next();
  }
  return all;
}

struct Measured {
  BodyCase recordings;
  std::vector<bool> fell;  // of each log

  [[nodiscard]] bool stands() const { return std::ranges::find(fell, true) == fell.end(); }
};

struct Wanted {
  bool past_a_fall = true, fitted_logs = true;
};

/// Those first in which it may fall, since a fall ends an attempt.
std::vector<std::size_t> orderOf(const std::vector<BodyLog>& logs) {
  std::vector<std::size_t> order(logs.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_partition(order.begin(), order.end(),
                        [&](std::size_t log) { return logs[log].setup != BodySetup::kClamped; });
  return order;
}

/// Logs of the plan by this robot.
Measured measured(const BodyCase& plan, const BodyTruth& robot, std::uint64_t noise_seed, const Wanted& wanted) {
  Measured out{.recordings = plan, .fell = std::vector<bool>(plan.logs.size())};
  for (const std::size_t log : orderOf(plan.logs)) {
    if (!wanted.fitted_logs && !plan.logs[log].held_out) continue;
    if (!wanted.past_a_fall && !out.stands()) break;
    const Disturbance noise{.seed = noise_seed + log};
    out.fell[log] = measureBody(out.recordings, log, robot, &noise);
  }
  return out;
}

/// Rms difference of the joints on held-out logs, mrad; where one of both fell, they have nothing in common.
double differenceOf(const Measured& a, const Measured& b) {
  double sum = 0, count = 0;
  for (std::size_t i = 0; i < a.recordings.joints.logs.size(); ++i) {
    const Trajectory &one = a.recordings.joints.logs[i], &other = b.recordings.joints.logs[i];
    if (!one.held_out || a.fell[i / kJoints] || b.fell[i / kJoints]) continue;
    for (std::size_t row = 0; row < one.rows(); ++row, ++count)
      sum += std::pow(one.position_rad[row] - other.position_rad[row], 2);
  }
  return 1e3 * std::sqrt(sum / count);
}

BodyTruth robotOf(const BodyRequest& request, const BodyCase& plan, Rng& rng) {
  BodyTruth truth{.model = {.robot = {.robot = {bodyBaselineOf(plan), {}}, .floor = {}}}, .outside = {}, .loose = {}};
  if (!request.wrong_numbers) return truth;
  truth.model.robot = drawnRobots(plan, truth.model.robot, rng.next(), 1).front();
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    truth.model.imu.gyro.bias[axis] = plan.sigmaOf("imu.gyro_bias_rad_s") * rng.normal();
    truth.model.imu.accel.bias[axis] = plan.sigmaOf("imu.accel_bias_m_s2") * rng.normal();
  }
  return truth;
}

}  // namespace

BodyRequests bodyRequests(std::uint64_t seed, BodyPart part) {
  Rng rng{seed};
  BodyRequests all;
  const auto wanted = [part](BodyPart one) { return part == one || part == BodyPart::kAll; };
  if (part == BodyPart::kQuick) addQuick(rng, all);
  if (wanted(BodyPart::kSingles)) addSingles(rng, all);
  if (wanted(BodyPart::kPairs)) addPairs(rng, all);
  for (std::size_t i = 0; wanted(BodyPart::kEffectFree) && i < kEffectFreeCases; ++i)
    all.push_back({.effects = {}, .wrong_numbers = i % 2 == 1});
  const std::vector<BodyEffect> outside = ofKind(BodyClass::kOutside);
  for (std::size_t i = 0; wanted(BodyPart::kOutside) && i < kOutsideCases; ++i)
    all.push_back({.effects = {outside[i % outside.size()]}});
  rng.shuffle(all);
  return named(std::move(all), rng);
}

BodyRequests bodyRequestsFor(std::uint64_t seed, const std::vector<std::string>& effects) {
  Rng rng{seed};
  BodyRequests all;
  for (const std::string& text : effects) {
    BodyRequest request;
    std::istringstream words{text};
    for (std::string word; std::getline(words, word, ',');) {
      if (word == "wrong")
        request.wrong_numbers = true;
      else if (word != "none")
        request.effects.push_back(bodyEffectCalled(word));
    }
    all.push_back(std::move(request));
  }
  return named(std::move(all), rng);
}

HiddenBody hiddenBody(const BodyRequest& request) {
  Rng rng{request.seed};
  for (int attempt = 1;; ++attempt) {
    HiddenBody out{.given = plannedBody(request.name, rng.next(), request.on_floor), .key = {}};
    if (request.wrong_numbers) out.given.trust = kTrust;
    out.key.is_exact = !request.wrong_numbers;
    BodyTruth truth = robotOf(request, out.given, rng);
    const BodyTruth believed = truth;
    for (const BodyKeyEffect& effect : request.given) hide(effect, out.given, truth, out.key);
    for (const BodyEffect& effect : request.effects) hide(effect, out.given, rng, truth, out.key);
    const std::uint64_t seed = rng.next();
    const bool may_fall = request.on_floor == FloorMotions::kBows || attempt >= request.tries;
    Measured made = measured(out.given, truth, seed, {.past_a_fall = may_fall});
    if (!may_fall && !made.stands()) continue;
    const auto differenceTo = [&](const BodyTruth& robot, std::uint64_t of_noise) {
      return differenceOf(made, measured(out.given, robot, of_noise, {.fitted_logs = false}));
    };
    out.key.noise_mrad = differenceTo(truth, seed + 100) / std::sqrt(2.0);
    out.key.gap_mrad = out.key.effects.empty() ? 0 : differenceTo(believed, seed);
    out.given = std::move(made.recordings);
    return out;
  }
}

void makeBodyCases(const std::string& folder, const BodyRequests& requests,
                   const std::function<void(std::size_t done, std::size_t of)>& progress) {
  namespace fs = std::filesystem;
  const fs::path cases = fs::path{folder} / "cases", key = fs::path{folder} / "key.json";
  if (fs::exists(cases) || fs::exists(key))
    throw std::runtime_error(folder + " has cases already; give another folder, or remove cases and key.json there");
  BodyKeys keys;
  std::mutex key_mutex;
  forEach(requests.size(), [&](std::size_t i) {
    HiddenBody made = hiddenBody(requests[i]);
    writeBodyCase(made.given, (cases / requests[i].name).string());
    const std::lock_guard lock{key_mutex};
    keys[requests[i].name] = std::move(made.key);
    if (progress) progress(keys.size(), requests.size());
  });
  writeBodyKeys(keys, key.string());
}

}  // namespace darwinop::gap
