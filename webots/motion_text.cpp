// Parser of .motion files: a header with the motors' names, then one line per pose.
#include "webots/motion_text.hpp"

#include <algorithm>
#include <charconv>
#include <limits>
#include <optional>
#include <stdexcept>

#include "core/text/number_text.hpp"
#include "hal/text_file.hpp"
#include "webots/messages.hpp"

namespace darwinop::webots_api {

namespace {

constexpr std::size_t kFirstColumn = 2;  // before it: magic and version, or time and name

/// Error in one line. Fields are counted from 1.
struct Refused {
  std::size_t field;
  std::string why;
};

std::vector<std::string_view> fieldsOf(std::string_view line) {
  std::vector<std::string_view> fields;
  for (;;) {
    const auto comma = line.find(',');
    fields.push_back(text::withoutBlanks(line.substr(0, comma)));
    if (comma == std::string_view::npos) return fields;
    line.remove_prefix(comma + 1);
  }
}

std::string quoted(std::string_view text) {
  return "\"" + std::string{text.substr(0, 40)} + "\"";
}

/// Digits only: no sign, no blanks.
std::optional<int> wholeNumber(std::string_view text) {
  int value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() || value < 0) return std::nullopt;
  return value;
}

/// MM:SS:mmm in milliseconds.
std::optional<int> timeFromText(std::string_view text) {
  const auto first = text.find(':'), second = text.find(':', first + 1);
  if (first == std::string_view::npos || second == std::string_view::npos) return std::nullopt;
  const auto minutes = wholeNumber(text.substr(0, first));
  const auto seconds = wholeNumber(text.substr(first + 1, second - first - 1));
  const auto ms = wholeNumber(text.substr(second + 1));
  if (!minutes || !seconds || !ms) return std::nullopt;
  const auto total = 60'000LL * *minutes + 1000LL * *seconds + *ms;
  if (total > std::numeric_limits<int>::max()) return std::nullopt;
  return static_cast<int>(total);
}

void readHeader(const std::vector<std::string_view>& fields, MotionText& motion) {
  if (fields[0] != "#WEBOTS_MOTION") throw Refused{1, "a motion file begins with #WEBOTS_MOTION"};
  if (fields.size() < kFirstColumn || fields[1] != "V1.0") throw Refused{2, "its version is not V1.0"};
  for (std::size_t i = kFirstColumn; i < fields.size(); ++i) {
    if (fields[i].empty()) throw Refused{i + 1, "a motor without a name"};
    for (const MotionCurve& curve : motion.curves)
      if (curve.motor == fields[i]) throw Refused{i + 1, "the motor " + quoted(fields[i]) + " has a column already"};
    motion.curves.push_back({std::string{fields[i]}, {}});
  }
}

void readPose(const std::vector<std::string_view>& fields, MotionText& motion) {
  const std::size_t wanted = kFirstColumn + motion.curves.size();
  const auto ms = timeFromText(fields[0]);
  if (!ms) throw Refused{1, quoted(fields[0]) + " is not a time; it is minutes:seconds:milliseconds, 00:01:500"};
  if (*ms < motion.duration_ms) throw Refused{1, "the time goes back"};
  if (fields.size() != wanted)
    throw Refused{
        std::min(fields.size(), wanted) + 1,
        "the line has " + std::to_string(fields.size()) + " fields, and the header asks for " + std::to_string(wanted)};
  motion.duration_ms = *ms;
  for (std::size_t i = kFirstColumn; i < wanted; ++i) {
    if (fields[i] == "*") continue;
    const auto rad = text::numberFromText(fields[i]);
    if (!rad) throw Refused{i + 1, quoted(fields[i]) + " is neither a number, in rad, nor *"};
    motion.curves[i - kFirstColumn].keys.push_back({*ms, *rad});
  }
}

}  // namespace

std::optional<double> MotionCurve::atOrFirst(double ms) const {
  if (keys.empty()) return std::nullopt;
  return at(std::max<double>(ms, keys.front().ms));
}

std::optional<double> MotionCurve::at(double ms) const {
  const auto after = std::ranges::upper_bound(keys, ms, {}, &MotionKey::ms);
  if (after == keys.begin()) return std::nullopt;
  const MotionKey& before = *std::prev(after);
  if (after == keys.end()) return before.rad;
  const double part = (ms - before.ms) / (after->ms - before.ms);
  return before.rad * (1 - part) + after->rad * part;  // this form cannot overflow for finite numbers
}

MotionText parseMotion(std::string_view text, const std::string& file) {
  MotionText motion;
  std::size_t poses = 0;
  for (std::size_t line = 1; line == 1 || !text.empty(); ++line) {
    const auto end = text.find('\n');
    const std::string_view content = text::withoutBlanks(text.substr(0, end));
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    if (line > 1 && content.empty()) continue;
    try {
      line == 1 ? readHeader(fieldsOf(content), motion) : readPose(fieldsOf(content), motion);
    } catch (const Refused& refused) {
      throw std::runtime_error(file + ":" + std::to_string(line) + ": field " + std::to_string(refused.field) + ": " +
                               refused.why);
    }
    poses += line > 1 ? 1 : 0;
  }
  if (poses == 0) throw std::runtime_error(file + ":2" + messages::kNoPose);
  return motion;
}

MotionText readMotion(const std::string& file) {
  const std::optional<std::string> text = readTextFile(file);
  if (!text) throw std::runtime_error(file + ": it cannot be opened");
  return parseMotion(*text, file);
}

}  // namespace darwinop::webots_api
