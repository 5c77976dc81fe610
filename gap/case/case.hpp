// A case: logs of one servo that swings an arm, and the model to be tested. docs/gap/cases.md shows the files. SI
// units; NaN: not known.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "core/joints.hpp"
#include "twin/bench/bench.hpp"
#include "twin/model/model.hpp"

namespace darwinop::gap {

/// When the goal of a row was written, as against the row's read: right after it (the host reads, then commands), or
/// before it.
enum class GoalOrder : std::uint8_t { kAfterRead, kBeforeRead };

/// Readings of one column that no servo can have made; they are NaN in the log.
struct MaskedReadings {
  std::string_view column;  // "pos"
  std::string_view why;     // "jump and come back"
  std::size_t rows = 0;
  std::uint32_t first_line = 0;  // of the file
};

/// One log. All columns have a value a row.
struct Trajectory {
  std::string file;                      // as the case names it: "fit_1.csv"
  std::string kind;                      // what the joint did: "steps"; logs of one kind have one noise
  bool held_out = false;                 // no fit uses it, and it names no effect; verifies the result
  std::optional<std::size_t> repeat_of;  // index of the log that this one repeats

  std::optional<Joint> joint;  // whose servo, in the recording of a robot

  double p_register = 32;                 // register 28
  std::vector<double> p_register_of_row;  // where it changes in the log; NaN: not known; empty: it does not
  double payload_kg = 0;
  std::optional<double> arm_mass_kg, length_m, supply_v;  // of this log's bench; none: those of the case
  double session_start_s = 0;                             // of the first row within the session
  bool is_session_known = true;                           // false: that start is not known, and counts as 0
  double speed_limit_rad_s = 0;                           // of the servo's own profile, register 32; 0: none

  std::vector<double> time_s;  // rises
  std::vector<double> goal_rad;
  std::optional<double> goal_before_rad;  // held before the first row; none: goal and torque of the first row
  std::vector<double> position_rad;       // NaN: masked, or not read
  // Of a recording of the runtime: when in a row its goals were written and the servo was read, s after time_s. Empty:
  // both at time_s, in GoalOrder.
  std::vector<double> written_s, read_s;
  bool is_phase_known = true;  // the servo's firmware runs in step with the rows; matters with read_s only
  std::vector<std::uint8_t> torque_on;
  std::vector<double> speed_rad_s, load, volt_v, temp_c;  // load: -1 to 1. NaN where the log has none
  std::vector<double> current_a;     // as the servo reports it; empty or NaN: not known. Nothing is fitted to it
  std::vector<double> warmth_c;      // temp_c without the steps of its register; empty: not smoothed
  std::vector<std::uint32_t> lines;  // of the file, for messages
  std::vector<MaskedReadings> masked;

  [[nodiscard]] std::size_t rows() const { return time_s.size(); }
  /// Register 28 from the command of this row on.
  [[nodiscard]] double pRegisterAt(std::size_t row) const {
    return p_register_of_row.empty() ? p_register : p_register_of_row[row];
  }
  /// A reading is that of a servo which has its own row's goals already.
  [[nodiscard]] bool isReadAfterWrite() const { return !read_s.empty(); }
  [[nodiscard]] double duration_s() const { return time_s.empty() ? 0 : time_s.back() - time_s.front(); }
};

/// Prior of a baseline number: relative standard deviation.
struct Prior {
  std::string number;  // a key of [servo] ("kt"), "payload", "length", or "coulomb.friction" of an effect
  double relative_sigma = 0;
};

/// Data sheet values of the servo, for a control law that the baseline does not have.
struct Datasheet {
  twin::ServoParameters servo;
  double relative_sigma = 0.05;
};

struct Case {
  std::string name;  // "e01"
  std::string folder;
  std::optional<Joint> joint;  // of a robot, whose servo this is; none: of no robot, or not known
  GoalOrder goal_order = GoalOrder::kAfterRead;
  std::optional<double> written_before_s;  // of kBeforeRead, as in Hypothesis; none: not known, a fit has to find it
  bool quantised = true;                   // the firmware sees its encoder in ticks
  twin::Model model;                       // baseline: servo and effects that are known to be there
  twin::Pendulum pendulum;                 // payload is each log's own
  std::vector<Prior> priors;
  std::optional<Datasheet> datasheet;
  std::vector<Trajectory> logs;
  std::vector<Trajectory> others;     // no number is fitted to them; those that are not held out are for validation
  std::vector<std::string> warnings;  // sentences about data that are unusual but usable
};

/// The effects of one servo of a model: those for all joints, and in their place those for `joint`.
std::vector<twin::EffectSetting> servoEffects(const twin::Model& model, std::optional<Joint> joint);

/// Arm of a log's bench, with its payload.
twin::Pendulum armOf(const Case& c, const Trajectory& log);
/// Nominal supply of a log's bench, V.
double supplyOf(const Case& c, const Trajectory& log);

/// The data or the case cannot be used; the text names file and line.
struct BadInput : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// `folder`: has a case.json and the logs it names. Throws BadInput.
Case readCase(const std::string& folder);

}  // namespace darwinop::gap
