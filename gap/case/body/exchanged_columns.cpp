#include "gap/case/body/exchanged_columns.hpp"

#include <cmath>
#include <functional>
#include <limits>
#include <vector>

#include "core/text/formatted.hpp"
#include "gap/case/body/row_law.hpp"
#include "gap/case/median.hpp"

namespace darwinop::gap {
namespace {

constexpr std::size_t kFewest = 50;     // rows
constexpr double kPlain = 0.1;          // rms, of full duty: as recorded, the law is off by more
constexpr double kMoves = 0.03;         // rms, of full duty, about the median: constants fit by chance
constexpr double kPlainlyBetter = 0.2;  // of that residual is left with the other column

/// Goal, position and load of one row: the law leaves the load minus its duty.
struct LawRow {
  double goal_rad, position_rad, load;
};
using ReadAs = std::function<LawRow(std::size_t row, LawRow as_recorded)>;

/// Of one joint in one recording.
class LawFit {
 public:
  LawFit(const BodyCase& given, std::size_t log, std::size_t joint)
      : servo_{given.joints.model.servo}, rows_{given.joint(log, joint)} {}

  [[nodiscard]] LawRow recorded(std::size_t row) const {
    return {rows_.goal_rad[writtenBefore(rows_, row)], rows_.position_rad[row], rows_.load[row]};
  }
  /// Rms of what the law leaves; NaN: too few rows.
  [[nodiscard]] double rms(const ReadAs& read) const {
    return rmsOf([&](std::size_t row, std::size_t written) {
      const LawRow of = read(row, recorded(row));
      return of.load - dutyFor(servo_, rows_.pRegisterAt(written), of.goal_rad - of.position_rad);
    });
  }
  [[nodiscard]] double loadRms(double from = 0) const {
    return rmsOf([&](std::size_t row, std::size_t) { return rows_.load[row] - from; });
  }

 private:
  template <class Residual>
  double rmsOf(const Residual& residual) const {
    double sum = 0;
    std::size_t count = 0;
    for (std::size_t row = 1; row < rows_.rows(); ++row) {
      const std::size_t written = writtenBefore(rows_, row);
      if (rows_.torque_on[written] == 0) continue;
      const double one = residual(row, written);
      if (!std::isnan(one)) sum += one * one, ++count;
    }
    return count < kFewest ? std::numeric_limits<double>::quiet_NaN() : std::sqrt(sum / static_cast<double>(count));
  }

  const twin::ServoParameters& servo_;
  const Trajectory& rows_;
};

struct OtherColumn {
  std::string text;
  ReadAs read;
};

constexpr std::size_t kOwnColumns = 3;

/// One column of the joint, read with the other sign, which are kOwnColumns, or from another joint.
std::vector<OtherColumn> otherColumns(const BodyCase& given, std::size_t log, std::size_t joint) {
  const std::string sign = messages::kOtherSign;
  std::vector<OtherColumn> out{{"load" + sign,
                                [](std::size_t, LawRow of) {
                                  return LawRow{of.goal_rad, of.position_rad, -of.load};
                                }},
                               {"position" + sign,
                                [](std::size_t, LawRow of) {
                                  return LawRow{of.goal_rad, -of.position_rad, of.load};
                                }},
                               {"commanded" + sign, [](std::size_t, LawRow of) {
                                  return LawRow{-of.goal_rad, of.position_rad, of.load};
                                }}};
  for (std::size_t other = 0; other < kJoints; ++other) {
    if (other == joint || given.is_absent[other]) continue;
    const LawFit its{given, log, other};
    const std::string of_other = " of " + std::string{kJointTable[other].name};
    out.push_back({"load" + of_other, [its](std::size_t row, LawRow of) {
                     return LawRow{of.goal_rad, of.position_rad, its.recorded(row).load};
                   }});
    out.push_back({"position" + of_other, [its](std::size_t row, LawRow of) {
                     return LawRow{of.goal_rad, its.recorded(row).position_rad, of.load};
                   }});
    out.push_back({"commanded" + of_other, [its](std::size_t row, LawRow of) {
                     return LawRow{its.recorded(row).goal_rad, of.position_rad, of.load};
                   }});
  }
  return out;
}

}  // namespace

void refuseExchangedColumns(const BodyCase& given, std::size_t log) {
  if (given.joints.model.servo.law != twin::Law::kVoltageP) return;
  for (std::size_t joint = 0; joint < kJoints; ++joint) {
    const LawFit fit{given, log, joint};
    const double load = fit.loadRms(), moves = fit.loadRms(medianOf(given.joint(log, joint).load));
    const double as_recorded = fit.rms([](std::size_t, LawRow of) { return of; });
    // The law has to be worse than none at all.
    if (given.is_absent[joint] || !(moves > kMoves) || !(as_recorded > std::max(kPlain, load))) continue;
    const OtherColumn* best = nullptr;
    double least = kPlainlyBetter * as_recorded;
    const std::vector<OtherColumn> others = otherColumns(given, log, joint);
    for (std::size_t i = 0; i < others.size(); ++i) {
      // A joint moves like the mirrored one of the other side with the other sign: that is the simpler explanation.
      if (i == kOwnColumns && best != nullptr) break;
      if (const double rms = fit.rms(others[i].read); rms < least) best = &others[i], least = rms;
    }
    if (best == nullptr) continue;
    throw BadInput(given.logs[log].file + ": " + best->text + messages::kFitsOtherColumn +
                   std::string{kJointTable[joint].name} +
                   text::formatted(" (rms %.3f of full duty), as recorded it is off by %.3f; correct the columns of ",
                                   least, as_recorded) +
                   std::string{kJointTable[joint].name} + " where the recording is written");
  }
}

}  // namespace darwinop::gap
