// Mirrors a page. Servo ids are in pairs, odd ids on the right; the head joints are single.
#include "managers/motion_text/mirror.hpp"

#include <algorithm>

#include "core/conversions.hpp"

namespace darwinop::motion {

namespace {

constexpr std::size_t kNeckId = row(Joint::kNeck).id, kHeadId = row(Joint::kHead).id;

constexpr std::size_t partner(std::size_t id) {
  if (id == 0 || id >= kNeckId) return id;
  return id % 2 == 1 ? id + 1 : id - 1;
}

constexpr bool partnersAreSideBySide() {
  for (std::size_t id = 1; id < kNeckId; id += 2) {
    const std::string_view right = kJointTable[id - 1].name, left = kJointTable[id].name;
    if (right.substr(0, right.size() - 1) != left.substr(0, left.size() - 1)) return false;
  }
  return true;
}
static_assert(partnersAreSideBySide());

std::uint16_t mirrored(std::uint16_t word, std::size_t id) {
  if (word > kTickMax || id == 0 || id >= kHeadId) return word;
  return static_cast<std::uint16_t>(std::min(2 * kTickCentre - word, kTickMax));
}

}  // namespace

Page mirrored(const Page& page) {
  Page other = page;
  for (std::size_t id = 0; id < kServos; ++id) {
    // Nibbles are not swapped: they are directions, but an MX-28 has one gain, taken from the high nibble.
    other.slopes.at(partner(id)) = page.slopes.at(id);
    for (std::size_t i = 0; i < kSteps; ++i)
      other.step.at(i).position.at(partner(id)) = mirrored(page.step.at(i).position.at(id), id);
  }
  return other;
}

}  // namespace darwinop::motion
