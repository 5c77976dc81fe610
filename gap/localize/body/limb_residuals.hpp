// Measured minus simulated motion of one limb in all logs with a clamped trunk, whitened: what noise, chaos of released
// joints and numbers within their priors explain counts once, not once a sample.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "gap/localize/body/body_nuisances.hpp"
#include "gap/localize/body/noise_modes.hpp"
#include "gap/plant/body/limb_roll_out.hpp"

namespace darwinop::gap {

/// Samples of one joint in one log: rows of the log from `begin` on.
struct LimbSamples {
  std::size_t log;     // index in the case
  Eigen::Index joint;  // in the limb
  bool is_load;        // measured load minus the control law at the measured position; else the position
  Eigen::Index begin, rows;
};

/// Logs with a clamped trunk that are held out, or the others.
std::vector<std::size_t> clampedLogs(const BodyCase& given, bool held_out);

class LimbResiduals {
 public:
  /// Noise and priors are those of robots near `about`. `numbers`: of nuisancesOf(), in prior standard deviations,
  /// where priors are linearized; their penalty stays in the residuals. Empty: where the model has them.
  LimbResiduals(const BodyCase& given, std::vector<std::size_t> logs, const Limb& limb, const BodyHypothesis& about,
                Eigen::VectorXd numbers = {});

  /// One step of Gauss and Newton towards the most probable numbers, no further than their priors reach. Nothing: no
  /// better ones were found.
  [[nodiscard]] std::optional<Eigen::VectorXd> betterNumbers(const BodyHypothesis& about) const;
  /// The same samples about other numbers.
  [[nodiscard]] std::unique_ptr<LimbResiduals> about(const BodyHypothesis& about, Eigen::VectorXd numbers) const {
    return std::make_unique<LimbResiduals>(given_, logs_, limb_, about, std::move(numbers));
  }
  /// The same numbers in those logs in which no joint of the limb is limp; null: these are all logs, or none, or no
  /// number is uncertain.
  [[nodiscard]] std::unique_ptr<LimbResiduals> withoutReleases(const BodyHypothesis& about) const;
  [[nodiscard]] const Eigen::VectorXd& numbers() const { return numbers_; }
  /// The same samples, with the numbers that such an effect stands for at its values.
  [[nodiscard]] std::unique_ptr<LimbResiduals> withNumbersOf(std::string_view effect, const std::vector<Joint>& at,
                                                             const std::vector<double>& values,
                                                             const BodyHypothesis& about) const;

  /// The hypothesis with the numbers about which priors are linearized, but for those that its own effects replace.
  [[nodiscard]] BodyHypothesis withNumbers(BodyHypothesis hypothesis) const {
    return moved(std::move(hypothesis), numbers_);
  }

  /// In standard deviations of one sample; a missing sample is 0.
  [[nodiscard]] Eigen::VectorXd scaled(const BodyHypothesis& hypothesis) const;
  /// Of such residuals or of their derivatives. Linear.
  [[nodiscard]] Eigen::VectorXd whitened(const Eigen::VectorXd& scaled) const { return modes_.whitened(scaled); }
  /// Whitened residuals.
  [[nodiscard]] Eigen::VectorXd of(const BodyHypothesis& hypothesis) const { return whitened(scaled(hypothesis)); }

  [[nodiscard]] const Limb& limb() const { return limb_; }
  [[nodiscard]] const std::vector<LimbSamples>& blocks() const { return blocks_; }
  [[nodiscard]] Eigen::Index size() const { return sigma_.size(); }
  /// Of each sample, its own part: rad, or duty.
  [[nodiscard]] const Eigen::VectorXd& sigma() const { return sigma_; }

 private:
  [[nodiscard]] Eigen::VectorXd simulated(const BodyHypothesis& hypothesis, const Disturbance* noise) const;
  void estimateNoise(const BodyHypothesis& about);
  void widenByWhatIsNotSpanned();
  void addPriors(const BodyHypothesis& about);
  /// An effect of the hypothesis has a number of its own.
  [[nodiscard]] bool isReplaced(std::size_t nuisance, const BodyHypothesis& by) const;
  /// A hypothesis with these numbers, but for those that its own effects replace.
  [[nodiscard]] BodyHypothesis moved(BodyHypothesis hypothesis, const Eigen::VectorXd& numbers) const;
  [[nodiscard]] Eigen::VectorXd inSigmasOf(const BodyHypothesis& exact) const;
  /// Minus twice the log posterior of numbers, but for a constant.
  [[nodiscard]] double costOf(const BodyHypothesis& about, const Eigen::VectorXd& numbers) const;
  /// Index in the robot.
  [[nodiscard]] std::size_t jointOf(const LimbSamples& block) const {
    return static_cast<std::size_t>(limb_[static_cast<std::size_t>(block.joint)].joint);
  }

  const BodyCase& given_;
  Limb limb_;
  std::vector<std::size_t> logs_;
  std::vector<LimbSamples> blocks_;
  Eigen::VectorXd measured_, sigma_;
  std::vector<BodyNuisance> nuisances_;
  Eigen::VectorXd numbers_;     // one of each nuisance
  Eigen::MatrixXd directions_;  // of noise and of priors, in sigmas
  NoiseModes modes_, modes_of_noise_;
};

}  // namespace darwinop::gap
