// Parses options of a virtual robot.
#include "hil-mocks/robot_options.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <stdexcept>

#include "core/board_models.hpp"
#include "core/text/letter_case.hpp"

namespace darwinop::hil {
namespace {

/// A setting "NAME:NUMBER".
struct NumberRow {
  std::string_view name;
  unsigned most;
  void (*set)(ServoOptions&, unsigned);
};
constexpr std::array kNumbers{
    NumberRow{"model", 65535, [](ServoOptions& s, unsigned n) { s.model = static_cast<std::uint16_t>(n); }},
    NumberRow{"drive-mode", 3, [](ServoOptions& s, unsigned n) { s.drive_mode = static_cast<std::uint8_t>(n); }},
    NumberRow{"firmware", 255, [](ServoOptions& s, unsigned n) { s.firmware = static_cast<std::uint8_t>(n); }},
    NumberRow{"id", 253, [](ServoOptions& s, unsigned n) { s.id = static_cast<std::uint8_t>(n); }},
    NumberRow{"return-delay", 254, [](ServoOptions& s, unsigned n) { s.return_delay = static_cast<std::uint8_t>(n); }},
    NumberRow{"status-level", 2, [](ServoOptions& s, unsigned n) { s.status_level = static_cast<std::uint8_t>(n); }},
    NumberRow{"cw-limit", kTickMax, [](ServoOptions& s, unsigned n) { s.cw_limit = static_cast<std::uint16_t>(n); }},
    NumberRow{"ccw-limit", kTickMax, [](ServoOptions& s, unsigned n) { s.ccw_limit = static_cast<std::uint16_t>(n); }},
    NumberRow{"max-torque", 1023, [](ServoOptions& s, unsigned n) { s.max_torque = static_cast<std::uint16_t>(n); }},
};

std::optional<unsigned> wholeNumber(std::string_view text) {
  unsigned value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return value;
}

std::optional<Joint> jointFrom(std::string_view text) {
  if (const auto id = wholeNumber(text); id && *id >= 1 && *id <= kJoints) return static_cast<Joint>(*id - 1);
  return findJoint(text);
}

bool setNumber(ServoOptions& servo, std::string_view setting) {
  const std::size_t colon = setting.find(':');
  if (colon == setting.npos) return false;
  const auto value = wholeNumber(setting.substr(colon + 1));
  for (const NumberRow& row : kNumbers) {
    if (row.name != setting.substr(0, colon) || !value || *value > row.most) continue;
    row.set(servo, *value);
    return true;
  }
  return false;
}

/// "cm-740"; null: there is none of this name.
const BoardModel* boardCalled(std::string_view name) {
  for (const BoardModel& model : kBoardModels)
    if (text::lowered(model.name) == text::lowered(name)) return &model;
  return nullptr;
}

}  // namespace

std::string servoSettings() {
  std::string text = "wheel, multi-turn, missing, keeps-torque, torque-control";
  for (const NumberRow& row : kNumbers)
    text.append(", ").append(row.name).append(":0..").append(std::to_string(row.most));
  return text;
}

void setServo(BoardOptions& options, std::string_view text) {
  const std::size_t equals = text.find('=');
  const auto joint = jointFrom(text.substr(0, equals));
  const std::string_view setting = equals == text.npos ? std::string_view{} : text.substr(equals + 1);
  if (joint) {
    ServoOptions& servo = options.servo[index(*joint)];
    if (setting == "wheel") return void(servo.cw_limit = servo.ccw_limit = 0);
    if (setting == "multi-turn") return void(servo.cw_limit = servo.ccw_limit = kTickMax);
    if (setting == "missing") return void(servo.missing = true);
    if (setting == "keeps-torque") return void(servo.keeps_torque = true);
    if (setting == "torque-control") return void(servo.torque_control = true);
    if (setNumber(servo, setting)) return;
  }
  throw std::runtime_error("--servo " + std::string{text} +
                           ": expected JOINT=SETTING, with a joint name or id and one of: " + servoSettings());
}

void setBoard(BoardOptions& options, std::string_view text) {
  constexpr std::string_view kModel = "model:";
  if (text == "no-bulk-read")
    options.bulk_read = false;
  else if (text == "no-sync-write")
    options.sync_write = false;
  else if (text == "one-block-length")
    options.only_block = 30;
  else if (const auto model = wholeNumber(text.substr(std::min(text.size(), kModel.size())));
           text.starts_with(kModel) && model && *model <= 0xFFFF)
    options.model = static_cast<std::uint16_t>(*model);
  else if (text == kNoBoard.name)
    options.board = false;
  else if (const auto* const row = boardCalled(text))
    options.model = row->number;
  else
    throw std::runtime_error(
        "--board " + std::string{text} +
        ": expected no-bulk-read, no-sync-write, one-block-length, cm-730, cm-740, none or model:0..65535");
}

}  // namespace darwinop::hil
