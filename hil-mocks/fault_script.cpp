// Parser of fault scripts.
#include "hil-mocks/fault_script.hpp"

#include <algorithm>
#include <functional>

#include "core/packet.hpp"
#include "hil-mocks/script_line.hpp"

namespace darwinop::hil {
namespace {

enum class Argument : std::uint8_t { kNone, kNumber, kBits, kButton, kFall };
enum class For : std::uint8_t { kAllowed, kNeeded, kForbidden };

struct KindRow {
  FaultKind kind;
  bool servo;
  Argument argument;
  double low, high;
  std::string_view unit;
  For lasts;
  bool over;
};

constexpr auto kKinds = std::to_array<KindRow>({
    {FaultKind::kDead, true, Argument::kNone, 0, 0, "", For::kAllowed, false},
    {FaultKind::kErrors, true, Argument::kBits, 0, 0, "", For::kAllowed, false},
    {FaultKind::kHeat, true, Argument::kNumber, 0, 255, "deg C", For::kAllowed, true},
    {FaultKind::kVoltage, false, Argument::kNumber, 0, 25, "V", For::kAllowed, true},
    {FaultKind::kReset, false, Argument::kNone, 0, 0, "", For::kForbidden, false},
    {FaultKind::kButton, false, Argument::kButton, 0, 0, "", For::kAllowed, false},
    {FaultKind::kFallen, false, Argument::kFall, 0, 0, "", For::kAllowed, false},
    {FaultKind::kStall, false, Argument::kNone, 0, 0, "", For::kNeeded, false},
    {FaultKind::kUnplug, false, Argument::kNone, 0, 0, "", For::kNeeded, false},
    {FaultKind::kJam, true, Argument::kNumber, 0.01, 60, "seconds under torque", For::kAllowed, false},
    {FaultKind::kMiss, false, Argument::kNumber, 1, 1000, "BULK_READs", For::kForbidden, false},
    {FaultKind::kBabble, false, Argument::kNumber, 1, 64, "bytes", For::kAllowed, false},
    {FaultKind::kTwins, true, Argument::kNone, 0, 0, "", For::kAllowed, false},
    {FaultKind::kSag, false, Argument::kNumber, 0, 100, "V", For::kAllowed, false},
    {FaultKind::kNoise, true, Argument::kNone, 0, 0, "", For::kAllowed, false},
    {FaultKind::kDrop, false, Argument::kNumber, 1, 255, "bytes", For::kAllowed, false},
    {FaultKind::kCorrupt, false, Argument::kNumber, 1, 255, "bytes", For::kAllowed, false},
    {FaultKind::kRepeat, false, Argument::kNumber, 1, 255, "bytes", For::kAllowed, false},
    {FaultKind::kRepeatFrame, false, Argument::kNone, 0, 0, "", For::kAllowed, false},
    {FaultKind::kDelay, false, Argument::kNumber, 0, 10000, "ms", For::kAllowed, false},
    {FaultKind::kGarbage, false, Argument::kNumber, 1, 255, "bytes", For::kAllowed, false},
    {FaultKind::kRandom, false, Argument::kNumber, 0.001, 1000, "faults a second", For::kAllowed, false},
});
static_assert(kKinds.size() == kFaultKinds);

struct BitName {
  std::string_view name;
  std::uint8_t bits;
};
constexpr auto kErrorNames = std::to_array<BitName>({{"voltage", error_bit::kVoltage},
                                                     {"angle_limit", error_bit::kAngleLimit},
                                                     {"overheat", error_bit::kOverheat},
                                                     {"range", error_bit::kRange},
                                                     {"checksum", error_bit::kChecksum},
                                                     {"overload", error_bit::kOverload},
                                                     {"instruction", error_bit::kInstruction}});
constexpr auto kButtonNames = std::to_array<BitName>({{"mode", 1}, {"start", 2}});
constexpr auto kFallNames = std::to_array<std::string_view>({"front", "back", "left", "right"});
constexpr auto kWayNames = std::to_array<std::string_view>({"replies", "requests", "both"});  // Way, minus one
constexpr Nanos kButtonPress = std::chrono::milliseconds{300};

template <class Range, class Name>
std::string listOf(const Range& range, Name&& name) {
  std::string list;
  for (const auto& item : range) list += (list.empty() ? "" : ", ") + std::string(name(item));
  return list;
}

void readServos(ScriptLine& line, InjectedFault& fault) {
  line.parts([&](std::string_view name) {
    if (name == "all") return void(fault.joints.set());
    const auto found = std::ranges::find_if(
        kJointTable, [&](const JointRow& row) { return name == row.name || name == std::to_string(row.id); });
    if (found == kJointTable.end())
      line.fail("expected servo names or ids joined by '+', or 'all'; names: " +
                listOf(kJointTable, [](const JointRow& row) { return row.name; }));
    fault.joints.set(found->id - std::size_t{1});
  });
}

template <std::size_t N>
void readBits(ScriptLine& line, const std::array<BitName, N>& names, InjectedFault& fault) {
  line.parts([&](std::string_view name) {
    const auto found = std::ranges::find(names, name, &BitName::name);
    if (found == names.end())
      line.fail("expected, joined by '+': " + listOf(names, [](const BitName& row) { return row.name; }));
    fault.bits |= found->bits;
  });
}

void readFall(ScriptLine& line, InjectedFault& fault) {
  const auto found = std::ranges::find(kFallNames, line.next());
  if (found == kFallNames.end()) line.fail("expected one of: " + listOf(kFallNames, std::identity{}));
  fault.fall = static_cast<Fall>(found - kFallNames.begin());
}

void readKinds(ScriptLine& line, InjectedFault& fault) {
  fault.kinds.reset();
  line.parts([&](std::string_view name) {
    const auto found = std::ranges::find(kFaultKindNames, name);
    if (found == kFaultKindNames.end() || name == "random") line.fail("expected other fault kinds joined by '+'");
    fault.kinds.set(static_cast<std::size_t>(found - kFaultKindNames.begin()));
  });
}

void readArgument(ScriptLine& line, const KindRow& row, InjectedFault& fault) {
  switch (row.argument) {
    case Argument::kNone:
      break;
    case Argument::kNumber:
      fault.amount = line.number(row.unit, row.low, row.high);
      break;
    case Argument::kBits:
      readBits(line, kErrorNames, fault);
      break;
    case Argument::kButton:
      readBits(line, kButtonNames, fault);
      fault.lasts = kButtonPress;
      break;
    case Argument::kFall:
      readFall(line, fault);
      break;
  }
}

/// Options after a fault, in any order.
void readOptions(ScriptLine& line, const KindRow& row, InjectedFault& fault) {
  const bool wire = isWireFault(row.kind);
  const bool has_chance_option = wire || row.kind == FaultKind::kErrors || row.kind == FaultKind::kNoise;
  bool has_for = false, has_chance = false;
  while (true) {
    const std::string_view word = line.next();
    const auto way = std::ranges::find(kWayNames, word);
    if (word.empty()) break;
    if (word == "for" && row.lasts != For::kForbidden) {
      fault.lasts = line.time("seconds", 0.001);
      has_for = true;
    } else if (word == "over" && row.over) {
      fault.over = line.time("seconds", 0);
    } else if (word == "boot" && row.kind == FaultKind::kDead) {
      fault.boot = std::chrono::milliseconds{static_cast<int>(line.number("ms", 0, 10000))};
    } else if (word == "chance" && has_chance_option) {
      fault.chance = line.number("a probability", 0, 1);
      has_chance = true;
    } else if (wire && way != kWayNames.end()) {
      fault.way = static_cast<Way>(1 + (way - kWayNames.begin()));
    } else if (word == "of" && row.kind == FaultKind::kRandom) {
      readKinds(line, fault);
    } else {
      line.fail(std::string("expected ") + (row.lasts == For::kForbidden ? "nothing" : "'for SECONDS'") +
                (row.over ? ", 'over SECONDS'" : "") + (row.kind == FaultKind::kDead ? ", 'boot MS'" : "") +
                (has_chance_option ? ", 'chance PROBABILITY'" : "") + (wire ? ", 'replies', 'requests', 'both'" : "") +
                (row.kind == FaultKind::kRandom ? ", 'of KIND+KIND'" : ""));
    }
  }
  if (row.lasts == For::kNeeded && !has_for) line.fail("'for SECONDS' is missing");
  if (wire && !has_for && !has_chance) fault.lasts = Nanos{0};
}

}  // namespace

std::vector<InjectedFault> parseFaultScript(std::string_view text, std::string_view file_name) {
  std::vector<InjectedFault> faults;
  for (std::size_t number = 1; !text.empty(); ++number) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view content = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));

    if (ScriptLine{content, file_name, number}.next().empty()) continue;
    ScriptLine line{content, file_name, number};
    InjectedFault fault;
    fault.at = line.time("seconds from the start", 0);
    if (faults.size() == kMostFaults) line.fail("a script has at most " + std::to_string(kMostFaults) + " faults");
    const auto name = std::ranges::find(kFaultKindNames, line.next());
    if (name == kFaultKindNames.end()) line.fail("fault kinds: " + listOf(kFaultKindNames, std::identity{}));
    const KindRow& row = kKinds[static_cast<std::size_t>(name - kFaultKindNames.begin())];
    fault.kind = row.kind;
    if (row.servo) readServos(line, fault);
    readArgument(line, row, fault);
    readOptions(line, row, fault);
    faults.push_back(fault);
  }
  return faults;
}

}  // namespace darwinop::hil
