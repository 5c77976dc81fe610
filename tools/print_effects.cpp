// Prints docs/twin/effects.md from the catalogue of effects; with `--check FILE` tells whether FILE still says the
// same.
#include <cstdio>
#include <fstream>
#include <iostream>
#include <iterator>
#include <sstream>
#include <string>
#include <string_view>

#include "twin/effects/catalogue.hpp"

namespace {

using namespace darwinop::twin;

constexpr const char* kHowToRenew = "./dev docs";

constexpr std::string_view kWhatAnEffectIs = R"([add-an-effect.md](add-an-effect.md) tells how to add one.

An effect is something that real servos do and an ideal one does not. A model file switches one on for all joints, or
for one of them, with all its parameters ([models.md](models.md)):

```ini
[effect coulomb]
friction = 0.025 N m
[effect backlash Neck]
play = 0.01 rad
```

At its neutral values an effect does nothing, to the last bit. A model file with a value outside the range is refused.
`log`: a scale, searched in its logarithm. `secondary`: it refines the effect, and a first search leaves it at its
typical value.

| Symbol | |
|---|---|
| `q`, `w` | angle and speed of the joint |
| `e` | set point minus measured angle |
| `u` | duty of the bridge, -1 to 1 |
| `P`, `K` | register of the P gain; duty per unit of it and radian |
| `V`, `i`, `R` | supply, current, resistance of the winding |
| `kt`, `ke` | torque per current, back EMF per speed |
| `tm`, `te` | torque of the motor, torque of the load on the joint |
| `F` | friction: brakes every motion, and holds up to so much |
| `T`, `t` | temperature, time in the session |
| `m`, `L`, `J` | mass, length and inertia of what the joint carries |

Everything is SI and seen at the horn. `te` is gravity and whatever touches the arm, without its own inertia: a joint at
rest has `te = -tm`.

Effects act in the order of this table:

)";

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.7g", value);
  return text;
}

std::string link(const EffectInfo& effect) {
  return "[`" + std::string{effect.id} + "`](#" + std::string{effect.id} + ")";
}

/// A bar would end a cell of a table.
std::string cell(std::string_view text) {
  std::string out;
  for (const char c : text) (c == '|' ? out += '\\' : out) += c;
  return out;
}

std::string notes(const Parameter& p) {
  std::string out = p.logarithmic ? "log" : "";
  if (p.secondary) out += out.empty() ? "secondary" : ", secondary";
  return out;
}

void printOverview(std::ostream& out) {
  out << "| Effect | | Acts on | Equation |\n|---|---|---|---|\n";
  for (const EffectInfo* effect : catalogue())
    out << "| " << link(*effect) << " | " << effect->title << " | " << name(effect->place) << " | `"
        << cell(effect->equation) << "` |\n";
}

void printEffect(std::ostream& out, const EffectInfo& effect) {
  out << "\n## " << effect.id << "\n\n"
      << "**" << effect.title << "**, acts on: " << name(effect.place) << "\n\n    " << effect.equation << "\n\n"
      << "| Parameter | Unit | Meaning | From | To | Neutral | Typical | |\n|---|---|---|---:|---:|---:|---:|---|\n";
  for (const Parameter& p : effect.parameters)
    out << "| `" << p.key << "` | " << p.unit << " | " << cell(p.meaning) << " | " << number(p.low) << " | "
        << number(p.high) << " | " << number(p.neutral) << " | " << number(p.typical) << " | " << notes(p) << " |\n";
  out << "\n- In logs: " << effect.signature << "\n- Taken for: ";
  const char* between = "";
  for (const EffectInfo* other : doublesOf(effect)) {
    out << between << link(*other);
    between = ", ";
  }
  out << "\n- Told apart by: " << effect.separated_by << "\n- Source: " << effect.source << "\n";
}

std::string page() {
  std::ostringstream out;
  out << "# Effects\n\nGenerated from the files in `twin/effects/` by `" << kHowToRenew << "`; do not edit.\n"
      << kWhatAnEffectIs;
  printOverview(out);
  for (const EffectInfo* effect : catalogue()) printEffect(out, *effect);
  return out.str();
}

int check(const char* path) {
  std::ifstream file{path};
  const std::string have{std::istreambuf_iterator<char>{file}, {}};
  if (have == page()) return 0;
  std::cerr << path << " is out of date: run `" << kHowToRenew << "` and commit the result\n";
  return 1;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc == 3 && std::string{argv[1]} == "--check") return check(argv[2]);
  if (argc != 1) {
    std::cerr << "usage: " << argv[0] << " [--check FILE]\n";
    return 2;
  }
  std::cout << page();
}
