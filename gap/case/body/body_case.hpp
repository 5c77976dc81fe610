// A case of the whole robot: recordings of its joints and of its inertial sensor, and the model to be tested.
// docs/gap/body.md shows the files. SI units; NaN: not known.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/joints.hpp"
#include "gap/case/case.hpp"

namespace darwinop::gap {

/// How the robot is held: the trunk clamped in a stand, free on the floor, or lying with stiff servos.
enum class BodySetup : std::uint8_t { kClamped, kFloor, kLying };
std::string_view name(BodySetup setup);

/// x, y, z.
using Axes = std::array<double, 3>;
using AxesColumns = std::array<std::vector<double>, 3>;

/// One recording, without the joints.
struct BodyLog {
  std::string file;
  bool held_out = false;
  BodySetup setup = BodySetup::kFloor;
  std::optional<Axes> up;                // clamped: unit vector in the trunk's frame (left, up, forward)
  std::string lies_on;                   // lying: back, front, left or right
  double session_start_s = 0;            // of row 0 within the session
  std::optional<std::size_t> repeat_of;  // index of the log that this one repeats
  double battery_v = 0;

  std::vector<double> time_s;          // from row 0
  AxesColumns gyro_rad_s, accel_m_s2;  // in the sensor's axes
  std::vector<double> board_v;
  std::size_t lost_rows = 0;        // gaps in `cycle`
  double from_s = 0, to_s = 0;      // what is used of the file, on its own clock
  std::optional<double> fell_at_s;  // on the floor: the robot falls here, and what follows is left out
  bool is_phase_known = true;       // the servos' firmware runs in step with the rows

  [[nodiscard]] std::size_t rows() const { return time_s.size(); }
};

/// Key of `trust`: by how much the declared direction of a clamped trunk is off about each axis, rad.
inline constexpr std::string_view kUpSigma = "up_rad";

struct BodyCase {
  std::string name, folder;
  std::string model;  // as case.json names it: a file in the folder, or a shipped model
  /// Model, priors, and each servo as a log of its own: joint j of log i is joints.logs[i * kJoints + j]. The pendulum
  /// of this case has no meaning.
  Case joints;
  std::map<std::string, double, std::less<>> trust;  // prior sigmas, by key; none: the numbers are exact
  std::vector<BodyLog> logs;
  std::vector<std::string> warnings;  // sentences about data that are unusual but usable
  std::array<bool, kJoints>
      is_absent{};  // joints that never answer: they count as limp, and their limbs are not tested

  [[nodiscard]] bool isComplete() const { return std::ranges::find(is_absent, true) == is_absent.end(); }
  /// Prior sigma of a number of the model; 0: exact.
  [[nodiscard]] double sigmaOf(std::string_view key) const {
    const auto found = trust.find(key);
    return found == trust.end() ? 0 : found->second;
  }
  [[nodiscard]] const Trajectory& joint(std::size_t log, std::size_t joint) const {
    return joints.logs[log * kJoints + joint];
  }
};

/// "Neck and Head: no answer ..."; empty: the robot is complete.
std::string absentText(const BodyCase& given);

/// True: case.json in this folder is of the whole robot. Throws BadInput.
bool isBodyCase(const std::string& folder);
/// Throws BadInput, a sentence with file, line or key, and what to do.
BodyCase readBodyCase(const std::string& folder);

}  // namespace darwinop::gap
