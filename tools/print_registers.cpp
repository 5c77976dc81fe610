// Prints docs/registers.md from the tables of core/.
#include <algorithm>
#include <cstdio>
#include <iostream>
#include <span>
#include <string>

#include "core/board_models.hpp"
#include "core/conversions.hpp"
#include "core/joints.hpp"
#include "core/registers.hpp"
#include "core/servo_models.hpp"

namespace {

using namespace darwinop;

constexpr int kFirstRam = 24;
constexpr bool eepromIsBelow(int address, std::span<const Register> table) {
  return std::ranges::all_of(table,
                             [=](const Register& r) { return (r.memory == Memory::kEeprom) == (r.address < address); });
}
static_assert(eepromIsBelow(kFirstRam, kCm730) && eepromIsBelow(kFirstRam, kMx28) &&
                  eepromIsBelow(kFirstRam, kStrongerMx),
              "the page has no column for it");

std::string number(double value, const char* format) {
  char text[32];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

std::string range(const Register& r) {
  if (r.access == Access::kRead) return "";
  return std::to_string(r.low) + ".." + std::to_string(r.high);
}

/// SI value = (raw - zero) * scale, as a person would write it; empty where the count is the value.
std::string law(const Register& r) {
  if (r.zero == 0 && r.scale == 1) return "";
  const std::string raw = r.zero == 0 ? "raw" : "(raw - " + number(r.zero, "%g") + ")";
  return raw + " x " + number(r.scale, "%.6g");
}

void printTable(std::ostream& out, std::span<const Register> table) {
  out << "| Address | Name | Bytes | Reset | Range | SI value | Unit | Note |\n|---:|---|---:|---:|---|---|---|---|\n";
  for (const Register& r : table) {
    out << "| " << int{r.address} << " | `" << r.name << "` | " << int{r.bytes} << " | " << r.reset << " | " << range(r)
        << " | " << law(r) << " | " << r.unit << " | " << r.note << " |\n";
  }
}

std::string radian(int ticks) {
  return number(radFromTicks(ticks).value, "%+.4f");
}

void printJoints(std::ostream& out) {
  out << "| Id | Webots name | Joint | Low, ticks | High, ticks | Start, ticks | Low, rad | High, rad | Start, rad |\n"
         "|---:|---|---|---:|---:|---:|---:|---:|---:|\n";
  for (const JointRow& j : kJointTable) {
    out << "| " << int{j.id} << " | `" << j.name << "` | " << j.anatomical << " | " << j.low << " | " << j.high << " | "
        << j.start << " | " << radian(j.low) << " | " << radian(j.high) << " | " << radian(j.start) << " |\n";
  }
}

void printBoards(std::ostream& out) {
  out << "| Model number | Board | Robot | Registers | Servo power | Absent devices | Not confirmed on hardware "
         "|\n|---:|---|---|---|---|---|---|\n";
  for (const BoardModel& b : kBoardModels)
    out << "| " << b.number << " | " << b.name << " | " << b.robot << " | " << b.registers << " | " << b.power << " | "
        << b.absent << " | " << b.unconfirmed << " |\n";
  out << "| | " << kNoBoard.name << " | " << kNoBoard.robot << " | " << kNoBoard.registers << " | " << kNoBoard.power
      << " | " << kNoBoard.absent << " | " << kNoBoard.unconfirmed << " |\n";
}

std::string_view use(ServoUse use) {
  switch (use) {
    case ServoUse::kDriven:
      return "yes";
    case ServoUse::kIfPermitted:
      return "if `servo_models` in robot.ini names it";
    case ServoUse::kRefused:
      return "no";
  }
  return "";
}

void printServoModels(std::ostream& out) {
  out << "| Model number | Servo | Driven | Stall torque, N m | No-load speed, rpm | Driven on robots, by upstream's "
         "software | Note "
         "|\n|---:|---|---|---:|---:|---|---|\n";
  for (const ServoModel& m : kServoModels)
    out << "| " << m.number << " | " << m.name << " | " << use(m.use) << " | " << number(m.stall_torque, "%.1f")
        << " | " << number(m.no_load_rpm, "%g") << " | " << (m.on_robots ? "yes" : "no") << " | " << m.note << " |\n";
}

void printPage(std::ostream& out) {
  out << "# Joints and registers\n\n"
         "Generated from `core/joints.hpp`, `core/registers.hpp`, `core/board_models.hpp` and `core/servo_models.hpp` "
         "by\n"
         "`./dev docs`; do not edit.\n"
         "Where sources disagree, the comments of those files name the conflict and the choice.\n\n"
         "## Joints\n\n"
         "2048 ticks are 0 rad, 4096 ticks are a turn. A rising tick is a positive angle, for every joint.\n\n";
  printJoints(out);
  out << "\n## Boards\n\nAny other board is refused; `board_model` in robot.ini permits one with the registers of a "
         "CM-730.\n\n";
  printBoards(out);
  out << "\n## Servo models\n\nAny other model is refused. Source: the vendor's manuals, at 12 V, protocol 1.0. Those "
         "that can be driven have\nthe registers, 4096 steps a turn, speed units and gains of an MX-28. A torque limit "
         "in N m means the same at each of\nthem: at most 2.5 N m; loads are relative to 2.5 N m.\n\n";
  printServoModels(out);
  out << "\n## CM-730, id " << int{kBoardId} << "\n\nA register without a range is read-only. Addresses below "
      << kFirstRam << " are EEPROM. A word has its low byte at the lower address.\n\n";
  printTable(out, kCm730);
  out << "\n## MX-28, ids 1 to " << kJoints << "\n\nProtocol 1.0, firmware 27 or newer.\n\n";
  printTable(out, kMx28);
  out << "\n## MX-64 and MX-106\n\nThe same, and these, which have to be 0: not confirmed on hardware.\n\n";
  printTable(out, kStrongerMx);
}

}  // namespace

int main() {
  printPage(std::cout);
}
