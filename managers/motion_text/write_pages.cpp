// Writes pages as text: one section per page, one row per joint, one column per step.
#include "managers/motion_text/page_text.hpp"
#include "managers/motion_text/values.hpp"

namespace darwinop::motion {

namespace {

constexpr std::size_t kKeyWidth = 14, kColumnWidth = 8;  // "gain ArmUpperR"; "-180.00" and a blank

std::string padded(const std::string& text, std::size_t width) {
  return text.size() < width ? std::string(width - text.size(), ' ') + text : text;
}

std::string entry(const std::string& key, const std::string& value) {
  return key + std::string(key.size() < kKeyWidth ? kKeyWidth - key.size() : 0, ' ') + " = " + value + "\n";
}

template <class TextOfStep>
std::string rowOf(const std::string& key, std::size_t columns, const TextOfStep& text) {
  std::string values;
  for (std::size_t i = 0; i < columns; ++i) values += (i == 0 ? "" : " ") + padded(text(i), kColumnWidth);
  return entry(key, values);
}

template <class Bytes>
std::string hexBytes(const Bytes& bytes) {
  std::string text;
  for (const auto byte : bytes) text += (text.empty() ? "" : " ") + byteText(static_cast<std::uint8_t>(byte));
  return text;
}

/// Quoted if printable, zero-padded and without quotes; otherwise as bytes.
std::string nameEntry(const Page& page) {
  const std::string_view name = page.nameText();
  bool plain = name.size() < Page::kNameBytes;
  for (const char letter : name) plain = plain && letter >= ' ' && letter <= '~' && letter != '"';
  for (std::size_t i = name.size(); i < Page::kNameBytes; ++i) plain = plain && page.name.at(i) == '\0';
  if (!plain) return entry("name_bytes", hexBytes(page.name));
  return name.empty() ? "" : entry("name", '"' + std::string{name} + '"');
}

std::string headerEntries(const Page& page, const Page& empty) {
  std::string text = nameEntry(page);
  const auto count = [&text](const char* key, std::uint8_t value, std::uint8_t omitted) {
    if (value != omitted) text += entry(key, std::to_string(value));
  };
  count("repeat", page.repeat, empty.repeat);
  count("next", page.next, empty.next);
  count("exit", page.exit, empty.exit);
  count("speed", page.speed, empty.speed);
  if (page.acceleration != empty.acceleration) text += entry("acceleration", secondsText(page.acceleration));
  if (page.schedule == kSpeedBased)
    text += entry("schedule", "speed");
  else
    count("schedule", page.schedule, empty.schedule);
  if (page.rest != empty.rest) text += entry("reserved", hexBytes(page.rest));
  for (std::size_t id = 0; id < kServos; ++id)
    if (page.slopes.at(id) != empty.slopes.at(id)) text += entry("gain " + servoText(id), gainText(page.slopes.at(id)));
  return text;
}

/// Number of columns: up to the last step that is played or not empty.
std::size_t columnsOf(const Page& page, const Page& empty) {
  std::size_t columns = kSteps;
  while (columns > page.steps && page.step.at(columns - 1) == empty.step.at(columns - 1)) --columns;
  return columns;
}

bool othersAreEmpty(const Step& step, const Step& empty) {
  for (std::size_t id = 0; id < kServos; ++id)
    if (!isJoint(id) && step.position.at(id) != empty.position.at(id)) return false;
  return true;
}

/// "keep" in the row "others" stands for the words of an empty page, which differ between ids.
bool othersAreEqual(const Step& step) {
  for (std::size_t id = 0; id < kServos; ++id)
    if (!isJoint(id) && step.position.at(id) != step.position.front()) return false;
  return step.position.front() != kUnusedWord;
}

/// Ids without a joint: one row if all words of a step are equal, as is usual.
std::string otherRows(const Page& page, const Page& empty, std::size_t columns) {
  bool all_empty = true, one_row = true;
  for (std::size_t i = 0; i < columns; ++i) {
    const bool is_empty = othersAreEmpty(page.step.at(i), empty.step.at(i));
    all_empty = all_empty && is_empty;
    one_row = one_row && (is_empty || othersAreEqual(page.step.at(i)));
  }
  if (all_empty) return "";
  if (one_row)
    return rowOf("others", columns, [&](std::size_t i) {
      const Step& step = page.step.at(i);
      return othersAreEmpty(step, empty.step.at(i)) ? "keep" : angleText(step.position.front());
    });
  std::string text;
  for (std::size_t id = 0; id < kServos; ++id)
    if (!isJoint(id))
      text += rowOf(servoText(id), columns, [&](std::size_t i) { return angleText(page.step.at(i).position.at(id)); });
  return text;
}

}  // namespace

Page defaultPage(std::size_t number) {
  if (number != 0) return emptyPage();
  Page zeros;
  zeros.repeat = zeros.schedule = zeros.speed = zeros.acceleration = 0;
  zeros.has_checksum = false;
  return zeros;
}

std::string writePage(const Page& page, std::size_t number) {
  const Page empty = emptyPage();
  std::string text = "[page " + std::to_string(number) + "]\n" + headerEntries(page, empty);
  const std::size_t columns = columnsOf(page, empty);
  if (columns != page.steps) text += entry("steps", std::to_string(page.steps));
  if (columns == 0) return text;
  const bool timed = page.schedule == kTimeBased;
  text += rowOf(timed ? "time" : "rate", columns, [&](std::size_t i) {
    return timed ? secondsText(page.step.at(i).time) : std::to_string(page.step.at(i).time);
  });
  text += rowOf("pause", columns, [&](std::size_t i) { return secondsText(page.step.at(i).pause); });
  for (std::size_t id = 1; id <= kJoints; ++id)
    text += rowOf(servoText(id), columns, [&](std::size_t i) { return angleText(page.step.at(i).position.at(id)); });
  return text + otherRows(page, empty, columns);
}

std::string writePages(const PageFile& pages) {
  std::string text = std::string{kTextTitle} + "\n";
  for (std::size_t i = 0; i < pages.size(); ++i)
    if (pages[i] != defaultPage(i)) text += "\n" + writePage(pages[i], i);
  return text;
}

}  // namespace darwinop::motion
