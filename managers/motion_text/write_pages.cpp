// Writes pages as text: a section a page, a row a joint, a column a step.
#include "managers/motion_text/page_text.hpp"
#include "managers/motion_text/values.hpp"

namespace darwinop::motion {

namespace {

constexpr std::size_t kKeyWidth = 14, kColumnWidth = 8;  // "gain ArmUpperR", and "-180.00" with a blank

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

/// In quotes when it can be told like that: printable, ended by zeros, without a quote of its own.
std::string nameEntry(const Page& page) {
  const std::string_view name = page.nameText();
  bool plain = name.size() < Page::kNameBytes;
  for (const char letter : name) plain = plain && letter >= ' ' && letter <= '~' && letter != '"';
  for (std::size_t i = name.size(); i < Page::kNameBytes; ++i) plain = plain && page.name.at(i) == '\0';
  if (!plain) return entry("name_bytes", hexBytes(page.name));
  return name.empty() ? "" : entry("name", '"' + std::string{name} + '"');
}

std::string headerEntries(const Page& page, const Page& usual) {
  std::string text = nameEntry(page);
  const auto count = [&text](const char* key, std::uint8_t value, std::uint8_t unsaid) {
    if (value != unsaid) text += entry(key, std::to_string(value));
  };
  count("repeat", page.repeat, usual.repeat);
  count("next", page.next, usual.next);
  count("exit", page.exit, usual.exit);
  count("speed", page.speed, usual.speed);
  if (page.acceleration != usual.acceleration) text += entry("acceleration", secondsText(page.acceleration));
  if (page.schedule == kSpeedBased)
    text += entry("schedule", "speed");
  else
    count("schedule", page.schedule, usual.schedule);
  if (page.rest != usual.rest) text += entry("reserved", hexBytes(page.rest));
  for (std::size_t id = 0; id < kServos; ++id)
    if (page.slopes.at(id) != usual.slopes.at(id)) text += entry("gain " + servoText(id), gainText(page.slopes.at(id)));
  return text;
}

/// Up to the last step that is played, or holds anything.
std::size_t columnsOf(const Page& page, const Page& usual) {
  std::size_t columns = kSteps;
  while (columns > page.steps && page.step.at(columns - 1) == usual.step.at(columns - 1)) --columns;
  return columns;
}

bool othersAreUsual(const Step& step, const Step& usual) {
  for (std::size_t id = 0; id < kServos; ++id)
    if (!isJoint(id) && step.position.at(id) != usual.position.at(id)) return false;
  return true;
}

/// "keep" in a row for all of them means the usual words, which are not the same everywhere.
bool othersAreAlike(const Step& step) {
  for (std::size_t id = 0; id < kServos; ++id)
    if (!isJoint(id) && step.position.at(id) != step.position.front()) return false;
  return step.position.front() != kUnusedWord;
}

/// The places of the file that have no joint: mostly all alike, and then one row says it.
std::string otherRows(const Page& page, const Page& usual, std::size_t columns) {
  bool all_usual = true, one_row = true;
  for (std::size_t i = 0; i < columns; ++i) {
    const bool as_usual = othersAreUsual(page.step.at(i), usual.step.at(i));
    all_usual = all_usual && as_usual;
    one_row = one_row && (as_usual || othersAreAlike(page.step.at(i)));
  }
  if (all_usual) return "";
  if (one_row)
    return rowOf("others", columns, [&](std::size_t i) {
      const Step& step = page.step.at(i);
      return othersAreUsual(step, usual.step.at(i)) ? "keep" : angleText(step.position.front());
    });
  std::string text;
  for (std::size_t id = 0; id < kServos; ++id)
    if (!isJoint(id))
      text += rowOf(servoText(id), columns, [&](std::size_t i) { return angleText(page.step.at(i).position.at(id)); });
  return text;
}

}  // namespace

Page unmentionedPage(std::size_t number) {
  if (number != 0) return emptyPage();
  Page zeros;
  zeros.repeat = zeros.schedule = zeros.speed = zeros.acceleration = 0;
  zeros.has_checksum = false;
  return zeros;
}

std::string writePage(const Page& page, std::size_t number) {
  const Page usual = emptyPage();
  std::string text = "[page " + std::to_string(number) + "]\n" + headerEntries(page, usual);
  const std::size_t columns = columnsOf(page, usual);
  if (columns != page.steps) text += entry("steps", std::to_string(page.steps));
  if (columns == 0) return text;
  const bool timed = page.schedule == kTimeBased;
  text += rowOf(timed ? "time" : "rate", columns, [&](std::size_t i) {
    return timed ? secondsText(page.step.at(i).time) : std::to_string(page.step.at(i).time);
  });
  text += rowOf("pause", columns, [&](std::size_t i) { return secondsText(page.step.at(i).pause); });
  for (std::size_t id = 1; id <= kJoints; ++id)
    text += rowOf(servoText(id), columns, [&](std::size_t i) { return angleText(page.step.at(i).position.at(id)); });
  return text + otherRows(page, usual, columns);
}

std::string writePages(const PageFile& pages) {
  std::string text = std::string{kTextTitle} + "\n";
  for (std::size_t i = 0; i < pages.size(); ++i)
    if (pages[i] != unmentionedPage(i)) text += "\n" + writePage(pages[i], i);
  return text;
}

}  // namespace darwinop::motion
