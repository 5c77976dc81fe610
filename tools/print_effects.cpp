// Prints docs/twin/effects.md from the catalogue of effects.
#include <algorithm>
#include <cctype>
#include <cstdio>
#include <iostream>
#include <string>
#include <string_view>
#include <vector>

#include "gap/identify/effect_set.hpp"
#include "twin/effects/catalogue.hpp"

namespace {

using namespace darwinop;
using twin::EffectInfo;
using twin::Parameter;

constexpr std::string_view kIntroduction = R"(# Effects

Generated from `twin/effects/` by `./dev docs`; do not edit. New effect: [add-an-effect.md](add-an-effect.md).

An effect is a deviation of a real servo from an ideal one. A [model file](models.md) switches it on, for all joints or
for one, with all its parameters:

```ini
[effect coulomb]
friction = 0.025 N m
[effect backlash Neck]
play = 0.01 rad
```
)";

constexpr std::string_view kHowToRead = R"(
Ranges of torques are those of an MX-28. A model file with a parameter outside its range, of a torque outside ten times its
range, or of another law is refused; a search stays inside, for friction in proportion to the stall torque. At the neutral
value (if not given: 0) the effect does nothing, to the last bit. The typical value is given if it differs. `log`: searched in its logarithm.
`secondary`: fixed at its typical value until the effect is accepted. Without a source the range is assumed.

Symbols, in SI units at the horn:

- `q`, `w`: angle and speed of the joint; `e`: set point minus measured angle
- `u`: duty, -1 to 1; `P`, `K`: P gain register, duty per unit of it and radian
- `V`, `i`, `R`: supply voltage, current, winding resistance; `kt`, `ke`: torque per current, back EMF per speed
- `tm`, `te`: motor torque, load torque without the arm's inertia (at rest `te = -tm`); `F`: friction torque
- `T`, `t`: temperature, session time; `m`, `L`, `J`: mass, length and inertia carried by the joint

Effects act in the order of this page. In parentheses: the part of the loop.
)";

using Listed = std::vector<const EffectInfo*>;

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.7g", value);
  return text;
}

std::string links(const Listed& effects) {
  std::string out;
  for (const EffectInfo* effect : effects) {
    const std::string id{effect->id};
    out += (out.empty() ? "[`" : ", [`") + id + "`](#" + id + ")";
  }
  return out;
}

Listed searchedWith(twin::Law law) {
  gap::Case given;
  given.model.servo.law = law;
  given.datasheet.emplace();
  return gap::candidateEffectsOf(given);
}

bool contains(const Listed& effects, const EffectInfo* effect) {
  return std::ranges::find(effects, effect) != effects.end();
}

void printExceptions(std::ostream& out) {
  const Listed voltage = searchedWith(twin::Law::kVoltageP), speed = searchedWith(twin::Law::kSpeedP);
  Listed only_voltage, only_speed, never;
  for (const EffectInfo* effect : twin::catalogue()) {
    const bool with_voltage = contains(voltage, effect), with_speed = contains(speed, effect);
    if (with_voltage && !with_speed) only_voltage.push_back(effect);
    if (!with_voltage && with_speed) only_speed.push_back(effect);
    if (!with_voltage && !with_speed) never.push_back(effect);
  }
  out << "\n[`darwinop gap`](../gap/README.md) searches every effect, with these exceptions:\n\n"
      << "- only in a baseline of law `voltage_p`: " << links(only_voltage) << '\n'
      << "- only in a baseline of law `speed_p` (`benchmark make-case --baseline W`) with a `servo_datasheet`: "
      << links(only_speed) << '\n'
      << "- never, because a host that reads every 16 ms cannot distinguish them from noise: " << links(never) << '\n';
}

void printParameter(std::ostream& out, const Parameter& p) {
  out << "- `" << p.key << "`, " << number(p.low) << ".." << number(p.high);
  if (!p.unit.empty()) out << ' ' << p.unit;
  std::string notes;
  const auto note = [&notes](const std::string& text) { notes += (notes.empty() ? "" : ", ") + text; };
  if (p.neutral != 0) note("neutral " + number(p.neutral));
  if (p.typical != p.neutral) note("typical " + number(p.typical));
  if (p.logarithmic) note("log");
  if (p.secondary) note("secondary");
  if (p.laws == twin::Laws::kVoltageP) note("law `voltage_p`");
  if (!notes.empty()) out << " (" << notes << ')';
  out << ": " << p.meaning << '\n';
}

void printEffect(std::ostream& out, const EffectInfo& effect) {
  std::string title{effect.title};
  title.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(title.front())));
  out << "\n## " << effect.id << "\n\n"
      << title << " (" << name(effect.part) << "):\n\n    " << effect.equation << "\n\n";
  for (const Parameter& p : effect.parameters) printParameter(out, p);
  out << "- Logs: " << effect.signature << "\n- Confounded with: " << links(twin::doublesOf(effect))
      << "\n- Separation: " << effect.separated_by << '\n';
  if (effect.source != "Range assumed") out << "- Source: " << effect.source << '\n';
}

}  // namespace

int main() {
  std::cout << kIntroduction;
  printExceptions(std::cout);
  std::cout << kHowToRead;
  for (const EffectInfo* effect : twin::catalogue()) printEffect(std::cout, *effect);
}
