// Text output of `darwinop motion`.
#include "motion_print.hpp"

#include <algorithm>

#include "core/text/number_text.hpp"
#include "managers/motion_text/dry_run.hpp"
#include "managers/motion_text/values.hpp"

namespace darwinop::motion {

namespace {

constexpr double kTickSeconds = kTickMs / 1000.0;
constexpr std::size_t kNameWidth = 14, kColumn = 9, kGainColumn = 8;

std::string right(const std::string& text, std::size_t width) {
  return std::string(text.size() < width ? width - text.size() : 0, ' ') + text;
}

std::string left(const std::string& text, std::size_t width) {
  return text + std::string(text.size() < width ? width - text.size() : 1, ' ');
}

std::string linkText(std::uint8_t page) {
  return page == 0 ? "-" : std::to_string(page);
}

std::string durationText(const PageFile& pages, int page) {
  const bool by_speed = pages.at(static_cast<std::size_t>(page)).schedule == kSpeedBased;
  return (by_speed ? ">" : "") + text::fixedText(ticksOf(pages, page) * kTickSeconds, 3) + " s";
}

/// Flag words have no angle.
std::string angle(std::uint16_t word) {
  return (word & (kKeep | kTorqueOff)) != 0 ? "keep" : angleText(word);
}

template <class TextOfStep>
std::string rowOf(const std::string& title, const Page& page, const TextOfStep& text) {
  std::string line = left(title, kNameWidth);
  for (std::size_t i = 0; i < page.steps; ++i) line += right(text(page.step.at(i)), kColumn);
  return line;
}

/// Duration of a step at the page's speed; speed-based pages have none.
std::string moveText(const Page& page, const Step& step) {
  const int scaled = std::max(1, (step.time * page.speed) >> 5);
  return page.schedule == kTimeBased ? text::fixedText(scaled * kTickSeconds, 3) : "v=" + std::to_string(scaled);
}

std::string pauseText(const Page& page, const Step& step) {
  const int ticks = step.pause * kDefaultSpeed / page.speed;
  return text::fixedText(ticks * kTickSeconds, 3);
}

}  // namespace

std::string nameOf(const Page& page) {
  std::string name;
  for (const char letter : page.nameText()) name += letter >= ' ' && letter <= '~' ? letter : '?';
  return name;
}

std::string listOf(const PageFile& pages) {
  std::string text = "page  name           steps  repeat  next  exit    duration\n";
  for (std::size_t i = 1; i < pages.size(); ++i) {
    const Page& page = pages[i];
    if (!page.canPlay()) continue;
    text += right(std::to_string(i), 4) + "  " + left(nameOf(page), kNameWidth) + right(std::to_string(page.steps), 6) +
            right(std::to_string(page.repeat), 8) + right(linkText(page.next), 6) + right(linkText(page.exit), 6) +
            right(durationText(pages, static_cast<int>(i)), 12) + '\n';
  }
  return text;
}

std::string pictureOf(const PageFile& pages, int number) {
  const Page& page = pages.at(static_cast<std::size_t>(number));
  std::string text = "page " + std::to_string(number) + " \"" + nameOf(page) + "\": " + durationText(pages, number) +
                     ", repeat " + std::to_string(page.repeat) + ", next " + linkText(page.next) + ", exit " +
                     linkText(page.exit) + ", acceleration " + secondsText(page.acceleration) + " s, speed " +
                     std::to_string(page.speed) + "\n\n";
  text += left("step", kNameWidth);
  for (int i = 1; i <= page.steps; ++i) text += right(std::to_string(i), kColumn);
  text += right("P gain", kGainColumn) + '\n';
  text += rowOf("move, s", page, [&](const Step& step) { return moveText(page, step); }) + '\n';
  text += rowOf("pause, s", page, [&](const Step& step) { return pauseText(page, step); }) + '\n';
  for (std::size_t id = 1; id <= kJoints; ++id)
    text += rowOf(servoText(id), page, [id](const Step& step) { return angle(step.position.at(id)); }) +
            right(std::to_string(pGainRegister(page.slopes.at(id))), kGainColumn) + '\n';
  return text + "\nAngles in degrees, 0 in the middle of the servo's range.\n";
}

}  // namespace darwinop::motion
