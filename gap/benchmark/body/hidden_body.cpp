#include "gap/benchmark/body/hidden_body.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "gap/benchmark/body/given_effects.hpp"
#include "gap/benchmark/body/visible_effect.hpp"
#include "gap/localize/body/drawn_robot.hpp"
#include "gap/plant/body/joint_alone.hpp"

namespace darwinop::gap {
namespace {

/// What an owner knows of a robot: relative, or in the unit of the key.
const std::map<std::string, double, std::less<>> kTrust{
    {"body.mass", 0.03},          {"body.com_m", 0.002},   {"servo", 0.03},
    {"servo.duty_per_kp", 0.01},  {"servo.armature", 0.1}, {"friction", 0.2},
    {"floor_friction", 0.15},     {"contact_time", 0.2},   {"imu.gyro_bias_rad_s", 0.03},
    {"imu.accel_bias_m_s2", 0.05}};

/// Noise standard deviations from which an effect counts as visible: those of the weakest effect in the example cases.
constexpr double kVisibleSigmas = 4;

struct Measured {
  BodyCase recordings;
  std::vector<bool> fell;  // of each log

  [[nodiscard]] bool stands() const { return std::ranges::find(fell, true) == fell.end(); }
};

/// Logs in which the robot may fall come first, since a fall ends an attempt.
std::vector<std::size_t> orderOf(const std::vector<BodyLog>& logs) {
  std::vector<std::size_t> order(logs.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_partition(order.begin(), order.end(),
                        [&](std::size_t log) { return logs[log].setup != BodySetup::kClamped; });
  return order;
}

enum class Logs : std::uint8_t { kFitted, kHeldOut };

/// Simulates these logs of the plan. `stop_at_fall`: logs after one in which the robot falls stay empty.
void measure(Measured& into, Logs which, const BodyTruth& robot, std::uint64_t noise_seed, bool stop_at_fall) {
  for (const std::size_t log : orderOf(into.recordings.logs)) {
    if (into.recordings.logs[log].held_out != (which == Logs::kHeldOut)) continue;
    if (stop_at_fall && !into.stands()) break;
    const Disturbance noise{.seed = noise_seed + log};
    into.fell[log] = measureBody(into.recordings, log, robot, &noise);
  }
}

/// Rms difference of the joints on held-out logs, mrad, without logs in which either robot fell; NaN: there are no
/// others.
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

/// The difference of two robots is visible in the held-out logs, or one of them alone falls. `again`: a repeat of `a`.
bool isVisible(const Measured& a, const Measured& b, const Measured& again) {
  std::vector<std::size_t> logs;
  for (std::size_t log = 0; log < a.fell.size(); ++log) {
    if (!a.recordings.logs[log].held_out || a.fell[log] || again.fell[log]) continue;
    if (b.fell[log]) return true;
    logs.push_back(log);
  }
  return worstDifference(a.recordings, b.recordings, again.recordings, logs) > kVisibleSigmas;
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

/// One draw of a robot with its effects, and its recordings.
class Attempt {
 public:
  Attempt(const BodyRequest& request, Rng& rng)
      : request_{request}, plan_{plannedBody(request.name, rng.next(), request.on_floor)} {
    if (request.wrong_numbers) plan_.trust = kTrust;
    key_.is_exact = !request.wrong_numbers;
    believed_ = without_drawn_ = robotOf(request, plan_, rng);
    for (const BodyKeyEffect& effect : request.given) hide(effect, plan_, without_drawn_, key_);
    truth_ = without_drawn_;
    for (const BodyEffect& effect : request.effects) {
      drawn_from_.push_back(rng);
      hide(effect, plan_, rng, truth_, key_);
    }
    seed_ = rng.next();
  }

  /// `is_last`: accepted even if a drawn effect is not visible. False: rejected, because of that or of a fall.
  bool record(bool may_fall, bool is_last) {
    made_ = unmeasured();
    measure(made_, Logs::kHeldOut, truth_, seed_, !may_fall);
    if (!may_fall && !made_.stands()) return false;
    again_ = heldOut(truth_, seed_ + 100);
    if (!is_last && !areDrawnVisible()) return false;
    measure(made_, Logs::kFitted, truth_, seed_, !may_fall);
    return may_fall || made_.stands();
  }
  HiddenBody result() {
    key_.noise_mrad = differenceOf(made_, again_) / std::sqrt(2.0);
    key_.gap_mrad = key_.effects.empty() ? 0 : differenceOf(made_, heldOut(believed_, seed_));
    return {std::move(made_.recordings), std::move(key_)};
  }

 private:
  [[nodiscard]] Measured unmeasured() const {
    return {.recordings = plan_, .fell = std::vector<bool>(plan_.logs.size())};
  }
  [[nodiscard]] Measured heldOut(const BodyTruth& robot, std::uint64_t seed) const {
    Measured out = unmeasured();
    measure(out, Logs::kHeldOut, robot, seed, false);
    return out;
  }
  /// Each drawn effect is visible. Not tested: given effects, which the caller has chosen, and effects outside of the
  /// catalogue, since a push occurs in a single log that may not be held out.
  [[nodiscard]] bool areDrawnVisible() const {
    for (std::size_t i = 0; i < drawn_from_.size(); ++i)
      if (request_.effects[i].kind != BodyClass::kOutside && !isVisible(made_, heldOut(without(i), seed_), again_))
        return false;
    return true;
  }
  /// The robot without one of the effects that were drawn.
  [[nodiscard]] BodyTruth without(std::size_t effect) const {
    BodyTruth others = without_drawn_;
    BodyKey ignored;
    for (std::size_t i = 0; i < drawn_from_.size(); ++i)
      if (Rng same = drawn_from_[i]; i != effect) hide(request_.effects[i], plan_, same, others, ignored);
    return others;
  }

  const BodyRequest& request_;
  BodyCase plan_;
  BodyKey key_;
  BodyTruth believed_, without_drawn_, truth_;
  std::vector<Rng> drawn_from_;  // before each effect
  std::uint64_t seed_ = 0;       // of the noise
  Measured made_, again_;
};

}  // namespace

HiddenBody hiddenBody(const BodyRequest& request) {
  Rng rng{request.seed};
  for (int attempt = 1;; ++attempt) {
    Attempt one{request, rng};
    const bool is_last = attempt >= request.tries, may_fall = is_last || request.on_floor == FloorMotions::kBows;
    if (one.record(may_fall, is_last)) return one.result();
  }
}

}  // namespace darwinop::gap
