// Rows of a recording and periods of a firmware run on two clocks.
#include "gap/plant/body/limb_roll_out.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/random.hpp"
#include "gap/plant/bench/roll_out.hpp"
#include "gap/plant/body/joint_alone.hpp"
#include "gap/plant/body/limb_simulation.hpp"

namespace darwinop::gap {
namespace {

constexpr double kInstant = 1e-6;  // of a firmware period

/// One recording on one hypothesis.
class LimbRun {
 public:
  LimbRun(const BodyCase& given, std::size_t log, const Limb& limb, const BodyHypothesis& hypothesis,
          const Disturbance* noise)
      : given_{given},
        hypothesis_{hypothesis},
        log_{log},
        members_{limb},
        limb_{given, log, limb, hypothesis, noise},
        is_noisy_{noise != nullptr},
        phase_{noise == nullptr ? 0 : splitMix(noise->seed)} {}

  LimbTrace run() {
    const std::vector<double>& time = rowsOf(0).time_s;
    const auto rows = static_cast<Eigen::Index>(time.size());
    LimbTrace out{Eigen::MatrixXd::Constant(rows, joints(), std::numeric_limits<double>::quiet_NaN()), {}};
    out.duty = out.position_rad;
    const bool is_phase_known = given_.logs[log_].is_phase_known;
    std::vector<long> read_at(members_.size());
    writeRow(0);
    next_ = -std::lround(LimbSimulation::kHeldBefore / limb_.period_s());
    for (Eigen::Index row = 0; row < rows; ++row) {
      const auto r = static_cast<std::size_t>(row);
      if (rowsOf(0).isReadAfterWrite()) {
        // Firmware that runs on its own is as old as its period when it is read, by chance.
        const double phase = is_phase_known ? 0 : is_noisy_ ? phase_.uniform() : kMeanPhase;
        runTo(cycleAt(r, rowsOf(0).written_s[r], phase));
        writeRow(r);
        for (Eigen::Index i = 0; i < joints(); ++i)
          read_at[static_cast<std::size_t>(i)] = cycleAt(r, rowsOf(i).read_s[r], phase);
        for (const long last = std::ranges::max(read_at);; limb_.cycle(), ++next_) {
          for (Eigen::Index i = 0; i < joints(); ++i)
            if (read_at[static_cast<std::size_t>(i)] == next_) readRow(row, i, out);
          if (next_ >= last) break;
        }
      } else {
        runTo(static_cast<long>(std::ceil(time[r] / limb_.period_s() - kInstant)));
        for (Eigen::Index i = 0; i < joints(); ++i) readRow(row, i, out);
        writeRow(r);
      }
      if (!limb_.isFinite()) break;
    }
    return out;
  }

 private:
  [[nodiscard]] Eigen::Index joints() const { return static_cast<Eigen::Index>(members_.size()); }
  [[nodiscard]] const Trajectory& rowsOf(Eigen::Index joint) const {
    return given_.joint(log_, static_cast<std::size_t>(members_[static_cast<std::size_t>(joint)].joint));
  }

  void writeRow(std::size_t row) {
    for (Eigen::Index i = 0; i < joints(); ++i) {
      takeRow(rowsOf(i), row, limb_.drive(i));
      limb_.drive(i).supply_v = supplyAt(given_.logs[log_], row, hypothesis_);
    }
  }

  void readRow(Eigen::Index row, Eigen::Index joint, LimbTrace& into) const {
    const twin::Signals& s = limb_.signals(joint);
    into.position_rad(row, joint) = s.measured_rad;
    into.duty(row, joint) = s.torque_on ? s.duty : 0;
  }

  void runTo(long cycle) {
    for (; next_ < cycle; ++next_) limb_.cycle();
  }

  /// The first cycle that is not over `after_s` behind the begin of a row.
  [[nodiscard]] long cycleAt(std::size_t row, double after_s, double phase) const {
    return static_cast<long>(std::floor((rowsOf(0).time_s[row] + after_s) / limb_.period_s() + phase + kInstant));
  }

  const BodyCase& given_;
  const BodyHypothesis& hypothesis_;
  std::size_t log_;
  const Limb& members_;
  LimbSimulation limb_;
  bool is_noisy_;
  Rng phase_;      // of the firmware against the rows, where it is not known
  long next_ = 0;  // firmware cycle; cycle 0 begins with row 0
};

}  // namespace

BodyHypothesis declaredRobot(const BodyCase& given) {
  return {.servos = bodyBaselineOf(given),
          .links = {},
          .has_board_supply = given.joints.model.body.battery_resistance_ohm > 0};
}

double supplyAt(const BodyLog& log, std::size_t row, const BodyHypothesis& hypothesis) {
  const bool is_measured = hypothesis.has_board_supply && row < log.board_v.size() && !std::isnan(log.board_v[row]);
  return is_measured ? log.board_v[row] : log.battery_v;
}

bool isRecorded(const BodyCase& given, const Limb& limb) {
  return std::ranges::none_of(limb,
                              [&](const Link& link) { return given.is_absent[static_cast<std::size_t>(link.joint)]; });
}

LimbTrace rollOut(const BodyCase& given, std::size_t log, const Limb& limb, const BodyHypothesis& hypothesis,
                  const Disturbance* noise) {
  return LimbRun{given, log, limb, hypothesis, noise}.run();
}

}  // namespace darwinop::gap
