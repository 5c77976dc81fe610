// The unit of a column of loads, which BAM's logs do not give: it follows from what the readings of all logs have in
// common. A few false readings decide nothing; they are masked.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

#include "gap/case/bam_log.hpp"
#include "gap/case/encodings.hpp"
#include "gap/case/messages.hpp"

namespace darwinop::gap {
namespace {

constexpr double kNotRead = std::numeric_limits<double>::quiet_NaN();
// Of the readings of a folder. Bad rows of logs that other people share are some in a thousand; a motion that needs
// more than half of the duty, or reverses, has more rows than that.
constexpr double kFew = 0.005;
// Registers of full duty end at 1000 or at 1023 counts; a count more is rounding.
constexpr double kThousand = 1'001, kFull = 1'023.5;

bool isWhole(double value) {
  return value == std::nearbyint(value);
}

/// What the readings have in common: all but a few, and more than a few.
class Column {
 public:
  Column(std::span<const BamLog> logs, const std::vector<double> BamLog::*of) {
    for (const BamLog& one : logs)
      for (const double value : one.*of)
        if (!std::isnan(value)) values_.push_back(value);
  }
  template <class Is>
  [[nodiscard]] bool nearlyAll(const Is& is) const {
    return share([&](double value) { return !is(value); }) <= kFew;
  }
  template <class Is>
  [[nodiscard]] bool some(const Is& is) const {
    return share(is) > kFew;
  }

 private:
  template <class Is>
  [[nodiscard]] double share(const Is& is) const {
    if (values_.empty()) return 0;
    return static_cast<double>(std::ranges::count_if(values_, is)) / static_cast<double>(values_.size());
  }
  std::vector<double> values_;
};

bool isInt16(double value) {
  return isWhole(value) && ((value >= 0 && value < kFull) || (value > 65'536 - kFull && value < 65'536));
}
bool isBit10(double value) {
  return isWhole(value) && value >= 0 && value < 2'048;
}
bool isSigned(double value) {
  return std::abs(value) < kFull;
}
bool isFraction(double value) {
  return !isWhole(value);
}
/// As between two counts, where rows were resampled; smaller ones may be of another unit.
bool isFractionOfCounts(double value) {
  return isFraction(value) && std::abs(value) > kFull / 10;
}

struct LoadUnit {
  bool (*fits)(const Column& column);
  bool (*is_one)(double value);  // a reading in this unit; others are masked
  double counts;                 // of 0.1 % of full duty, in one
  CountSign sign;
  const char* reason;
};
/// The first that fits.
constexpr auto kUnits = std::to_array<LoadUnit>({
    {[](const Column& of) { return of.nearlyAll(isInt16) && of.some([](double n) { return n > 32'767; }); }, isInt16, 1,
     CountSign::kTwosComplement16, "counts above 32767: 16 bits in two's complement, logged without sign"},
    {[](const Column& of) { return of.nearlyAll(isBit10) && of.some([](double n) { return n >= 1'024; }); }, isBit10, 1,
     CountSign::kBit10, "counts up to 2047 and none below 0: bit 10 is the sign"},
    {[](const Column& of) {
       return of.nearlyAll([](double share) { return isSigned(share * 1'000); }) && of.some(isFraction);
     },
     [](double share) { return isSigned(share * 1'000); }, 1'000, CountSign::kUnsigned,
     "fractions, nothing beyond 1: a share of the greatest duty"},
    {[](const Column& of) {
       return of.nearlyAll([](double percent) { return isSigned(percent * 10); }) && of.some(isFraction);
     },
     [](double percent) { return isSigned(percent * 10); }, 10, CountSign::kUnsigned,
     "fractions, nothing beyond 100: percent"},
    {[](const Column& of) { return of.nearlyAll(isSigned) && (!of.some(isFraction) || of.some(isFractionOfCounts)); },
     isSigned, 1, CountSign::kUnsigned, "nothing beyond 1023: 0.1 % a count"},
});

/// Share of full duty of a count without `sign`.
double withSign(double count, CountSign sign) {
  if (sign == CountSign::kBit10 && count >= 1'024) return 1'024 - count;
  if (sign == CountSign::kTwosComplement16 && count >= 32'768) return count - 65'536;
  return count;
}

/// Counts of full duty: those of the X series end at 885, others at 1023 if some readings are above 1000.
double fullDuty(const LoadUnit& unit, const Column& column, bool x_series) {
  if (unit.sign == CountSign::kTwosComplement16 && x_series) return 885;
  const auto beyond = [&](double value) {
    return unit.is_one(value) && std::abs(withSign(value, unit.sign)) * unit.counts > kThousand;
  };
  return column.some(beyond) ? 1'023 : 1'000;
}

bool isOfXSeries(const std::string& motor) {
  return !motor.empty() && (motor.front() == 'x' || motor.front() == 'X');
}

void takeLoad(const LoadUnit& unit, double full, const std::vector<double>& column, const std::string& key,
              BamLog& into) {
  std::size_t masked = 0;
  std::ranges::transform(column, into.log.load.begin(), [&](double value) {
    if (std::isnan(value)) return kNotRead;
    if (!unit.is_one(value)) return ++masked, kNotRead;
    return std::clamp(withSign(value, unit.sign) * (unit.counts / full), -1.0, 1.0);
  });
  into.notes.push_back(into.log.file + ": " + key + " is read as load, " + unit.reason + "; full duty is " +
                       std::to_string(static_cast<int>(full)));
  if (masked > 0)
    into.notes.push_back(into.log.file + ": " + std::to_string(masked) + " of " + std::to_string(column.size()) +
                         messages::kLoadsMasked + key);
}

bool isRead(double value) {
  return value != 0;
}

/// The load of a servo pushes towards the goal, so that a column that nearly always pushes away has the other sign.
bool isMirrored(const std::vector<BamLog>& logs) {
  constexpr double kPlain = 0.03;        // of full duty: less may have either sign
  constexpr double kPlainError = 0.01;   // rad: seven steps of the encoder
  constexpr double kNearlyAlways = 0.9;  // rows at a turn of the motion have either sign
  std::size_t plain = 0, away = 0;
  for (const BamLog& one : logs)
    for (std::size_t row = 1; row < one.log.rows(); ++row) {
      const double error = one.log.goal_rad[row - 1] - one.log.position_rad[row], load = one.log.load[row];
      if (one.log.torque_on[row] == 0 || !(std::abs(error) > kPlainError) || !(std::abs(load) > kPlain)) continue;
      ++plain;
      if (error * load < 0) ++away;
    }
  return plain > 0 && static_cast<double>(away) > kNearlyAlways * static_cast<double>(plain);
}

}  // namespace

void convertLoads(std::vector<BamLog>& logs) {
  const Column load{logs, &BamLog::load}, torque{logs, &BamLog::torque};
  const bool of_load = load.some(isRead) || !torque.some(isRead);
  const Column& column = of_load ? load : torque;
  const std::string key = of_load ? "load" : "torque";
  const auto* const unit = std::ranges::find_if(kUnits, [&](const LoadUnit& one) { return one.fits(column); });
  for (BamLog& one : logs) {
    const std::vector<double>& values = of_load ? one.load : one.torque;
    const std::string file = one.log.file + ": ";
    if (!Column{std::span{&one, 1}, of_load ? &BamLog::load : &BamLog::torque}.some(isRead)) {
      if (std::ranges::any_of(one.load, [](double value) { return !std::isnan(value); }))
        one.notes.push_back(file + messages::kLoadIsZero + messages::kNotMeasured);
    } else if (unit == kUnits.end()) {
      one.notes.push_back(file + key + messages::kLoadNotRecognized);
    } else {
      takeLoad(*unit, fullDuty(*unit, column, isOfXSeries(one.motor)), values, key, one);
      if (!of_load) one.notes.back() += "; " + std::string{messages::kLoadIsZero};
    }
  }
  if (!isMirrored(logs)) return;
  for (BamLog& one : logs) {
    for (double& value : one.log.load) value = -value;
    one.notes.push_back(one.log.file + ": " + messages::kLoadIsMirrored);
  }
}

}  // namespace darwinop::gap
