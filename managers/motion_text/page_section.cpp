// Parses the fields of one page.
#include "managers/motion_text/page_section.hpp"

#include <algorithm>
#include <stdexcept>

#include "managers/motion_text/values.hpp"

namespace darwinop::motion {

namespace {

constexpr const char* kAngle = "an angle: degrees from -180.00 to 179.91, 'keep', or a word of the file such as 0x4000";
constexpr const char* kSeconds = "a time: 0 to 2.04 seconds, in steps of 0.008";
constexpr const char* kGain = "a gain: 4, 8, 16, 32, 64 or 128, or the slopes of the file such as 0x57";
constexpr const char* kCount = "an integer from 0 to 255";

std::vector<std::string_view> wordsOf(std::string_view text) {
  std::vector<std::string_view> words;
  constexpr std::string_view kBlank = " \t";
  for (std::size_t at = text.find_first_not_of(kBlank); at != text.npos; at = text.find_first_not_of(kBlank, at)) {
    const std::size_t end = std::min(text.find_first_of(kBlank, at), text.size());
    words.push_back(text.substr(at, end - at));
    at = end;
  }
  return words;
}

/// Input text for a message: truncated, without control characters.
std::string excerpt(std::string_view text) {
  constexpr std::size_t kMaxLength = 40;
  std::string shown{text.substr(0, kMaxLength)};
  std::ranges::replace_if(
      shown, [](char letter) { return letter < ' ' || letter > '~'; }, '?');
  return "'" + shown + (text.size() > kMaxLength ? "..." : "") + "'";
}

template <class Value>
Value required(std::optional<Value> value, const std::string& field, std::string_view text, const std::string& what) {
  if (!value) throw std::runtime_error(field + ": " + excerpt(text) + " is not " + what);
  return *value;
}

template <class Byte, std::size_t kSize>
void setBytes(std::array<Byte, kSize>& bytes, const std::string& key, std::string_view value) {
  const auto words = wordsOf(value);
  if (words.size() != kSize)
    throw std::runtime_error(key + ": has " + std::to_string(words.size()) + " bytes; must have " +
                             std::to_string(kSize));
  for (std::size_t i = 0; i < kSize; ++i)
    bytes.at(i) = static_cast<Byte>(required(byteFromText(words[i]), key, words[i], "a byte of two digits, 00 to FF"));
}

}  // namespace

void PageSection::set(const std::string& key, std::string_view value) {
  if (!seen_.insert(key).second) throw std::runtime_error(key + ": set twice in this page; remove one");
  if (!setHeader(key, value) && !setGain(key, value) && !setRow(key, value))
    throw std::runtime_error(excerpt(key) +
                             " is not a field of a page; use a joint name, or one of name, repeat, next, exit, "
                             "speed, acceleration, schedule, steps, time, rate, pause, gain JOINT, others");
}

void PageSection::setName(std::string_view value) {
  const std::size_t longest = Page::kNameBytes - 1;  // a zero ends it
  if (value.size() < 2 || value.front() != '"' || value.back() != '"')
    throw std::runtime_error("name: put it into double quotes, as in name = \"bow\"");
  value = value.substr(1, value.size() - 2);
  if (value.size() > longest)
    throw std::runtime_error("name: has " + std::to_string(value.size()) + " characters; at most 13 are allowed");
  const auto printable = [](char letter) { return letter >= ' ' && letter <= '~' && letter != '"'; };
  if (!std::ranges::all_of(value, printable))
    throw std::runtime_error("name: use printable ASCII characters without double quotes");
  std::ranges::copy(value, page_.name.begin());
}

void PageSection::setSchedule(std::string_view value) {
  if (value == "time" || value == "speed")
    page_.schedule = value == "time" ? kTimeBased : kSpeedBased;
  else
    page_.schedule = required(countFromText(value), "schedule", value, "'time' or 'speed'");
}

bool PageSection::setHeader(const std::string& key, std::string_view value) {
  const auto count = [&](std::uint8_t& field) { field = required(countFromText(value), key, value, kCount); };
  if (key == "name")
    setName(value);
  else if (key == "name_bytes")
    setBytes(page_.name, key, value);
  else if (key == "reserved")
    setBytes(page_.rest, key, value);
  else if (key == "schedule")
    setSchedule(value);
  else if (key == "acceleration")
    page_.acceleration = required(secondsFromText(value), key, value, kSeconds);
  else if (key == "steps")
    page_.steps = required(countFromText(value, kSteps), key, value, "an integer from 0 to 7");
  else if (key == "repeat")
    count(page_.repeat);
  else if (key == "next")
    count(page_.next);
  else if (key == "exit")
    count(page_.exit);
  else if (key == "speed")
    count(page_.speed);
  else
    return false;
  return true;
}

bool PageSection::setGain(const std::string& key, std::string_view value) {
  constexpr std::string_view kWord = "gain ";
  if (!key.starts_with(kWord)) return false;
  const auto servo = servoFromText(std::string_view{key}.substr(kWord.size()));
  if (!servo) return false;
  page_.slopes.at(*servo) = required(gainFromText(value), key, value, kGain);
  return true;
}

std::vector<std::string_view> PageSection::columnsOf(const std::string& key, std::string_view value) {
  auto words = wordsOf(value);
  if (words.empty() || words.size() > kSteps)
    throw std::runtime_error(key + ": has " + std::to_string(words.size()) + " values; a page has 1 to 7 steps");
  if (!columns_) {
    columns_ = words.size();
    first_row_ = key;
  }
  if (words.size() != *columns_)
    throw std::runtime_error(key + ": has " + std::to_string(words.size()) + " values, but " + first_row_ + " has " +
                             std::to_string(*columns_) + "; give one per step in every row");
  return words;
}

bool PageSection::setRow(const std::string& key, std::string_view value) {
  const auto servo = servoFromText(key);
  const bool times = key == "time", rates = key == "rate", pauses = key == "pause", others = key == "others";
  if (!servo && !times && !rates && !pauses && !others) return false;
  const auto words = columnsOf(key, value);
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::string field = key + ", step " + std::to_string(i + 1);
    Step& step = page_.step.at(i);
    if (times)
      step.time = required(secondsFromText(words[i]), field, words[i], kSeconds);
    else if (rates)
      step.time = required(countFromText(words[i]), field, words[i], kCount);
    else if (pauses)
      step.pause = required(secondsFromText(words[i]), field, words[i], kSeconds);
    else if (servo)
      step.position.at(*servo) = required(angleFromText(words[i]), field, words[i], kAngle);
    else
      setOthers(i, required(angleFromText(words[i]), field, words[i], kAngle));
  }
  return true;
}

void PageSection::setOthers(std::size_t step, std::uint16_t word) {
  const Step empty = emptyPage().step.at(step);
  for (std::size_t id = 0; id < kServos; ++id)
    if (!isJoint(id)) page_.step.at(step).position.at(id) = word == kUnusedWord ? empty.position.at(id) : word;
}

Page PageSection::finish() {
  const auto has = [this](const char* key) { return seen_.contains(key); };
  const std::size_t columns = columns_.value_or(0);
  if (!has("steps")) page_.steps = static_cast<std::uint8_t>(columns);
  if (page_.steps > columns)
    throw std::runtime_error("steps: is " + std::to_string(page_.steps) + ", but the rows have " +
                             std::to_string(columns) + " values");
  const char* const required_row = page_.schedule == kTimeBased ? "time" : "rate";
  const char* const other = page_.schedule == kTimeBased ? "rate" : "time";
  if (has(other))
    throw std::runtime_error(std::string{other} + ": a page by " + (page_.schedule == kTimeBased ? "time" : "speed") +
                             " needs a row '" + required_row + "' instead");
  if (columns > 0 && !has(required_row))
    throw std::runtime_error(std::string{required_row} +
                             ": the row is missing; add it to set the duration of each step");
  if (has("name") && has("name_bytes")) throw std::runtime_error("name_bytes: the page already has a name");
  for (std::size_t id = 0; has("others") && id < kServos; ++id)
    if (!isJoint(id) && seen_.contains(servoText(id)))
      throw std::runtime_error(servoText(id) + ": the page already has 'others'");
  if (page_.canPlay() && page_.schedule != kTimeBased && page_.schedule != kSpeedBased)
    throw std::runtime_error("schedule: is " + std::to_string(page_.schedule) + "; must be 'time' or 'speed'");
  if (page_.canPlay() && page_.speed == 0) throw std::runtime_error("speed: is 0; must be 1 to 255, default 32");
  return page_;
}

}  // namespace darwinop::motion
