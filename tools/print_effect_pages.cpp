// Writes docs/gap/effects/: a page for each effect of the catalogue, and a list of them. With `--check` tells whether
// the folder still says the same.
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <map>
#include <sstream>
#include <string>
#include <string_view>

#include "gap/identify/effect_set.hpp"
#include "twin/effects/catalogue.hpp"

namespace {

using namespace darwinop;
using twin::EffectInfo;
using twin::Parameter;
namespace fs = std::filesystem;

constexpr const char* kHowToRenew = "./dev docs";

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.7g", value);
  return text;
}

/// A bar would end a cell of a table.
std::string cell(std::string_view text) {
  std::string out;
  for (const char c : text) (c == '|' ? out += '\\' : out) += c;
  return out;
}

std::string link(const EffectInfo& effect) {
  return "[`" + std::string{effect.id} + "`](" + std::string{effect.id} + ".md)";
}

std::string notes(const Parameter& p) {
  std::string out = p.logarithmic ? "log" : "";
  if (p.secondary) out += out.empty() ? "secondary" : ", secondary";
  return out;
}

/// Whether a baseline of this law makes darwinop gap look for the effect.
bool isSuspect(const EffectInfo& effect, twin::Law law) {
  gap::Case given;
  given.model.servo.law = law;
  given.datasheet.emplace();
  const auto suspects = gap::candidateEffectsOf(given);
  return std::find(suspects.begin(), suspects.end(), &effect) != suspects.end();
}

std::string lookedFor(const EffectInfo& effect) {
  const bool voltage = isSuspect(effect, twin::Law::kVoltageP), speed = isSuspect(effect, twin::Law::kSpeedP);
  if (voltage && speed) return "from a baseline of either law";
  if (voltage) return "from a baseline of law `voltage_p`; the motor of `speed_p` has no such thing";
  if (speed) return "from a baseline of law `speed_p` whose case has a `servo_datasheet`; `voltage_p` is this law";
  return "never: a host that reads every 16 ms sees of it what it sees of noise";
}

void printParameters(std::ostream& out, const EffectInfo& effect) {
  out << "## Parameters\n\n"
      << "| Parameter | Unit | Meaning | From | To | Neutral | Typical | |\n|---|---|---|---:|---:|---:|---:|---|\n";
  bool logarithmic = false, secondary = false;
  for (const Parameter& p : effect.parameters) {
    out << "| `" << p.key << "` | " << p.unit << " | " << cell(p.meaning) << " | " << number(p.low) << " | "
        << number(p.high) << " | " << number(p.neutral) << " | " << number(p.typical) << " | " << notes(p) << " |\n";
    logarithmic = logarithmic || p.logarithmic;
    secondary = secondary || p.secondary;
  }
  out << "\nAt the neutral value it does nothing; a search stays between from and to.";
  if (logarithmic) out << " `log`: searched in its logarithm.";
  if (secondary) out << " `secondary`: stays at its typical value until the effect is accepted.";
  out << '\n';
}

void printTrial(std::ostream& out, const EffectInfo& effect) {
  const bool voltage = isSuspect(effect, twin::Law::kVoltageP), speed = isSuspect(effect, twin::Law::kSpeedP);
  if (!voltage && !speed) return;
  const bool friction = effect.id == "coulomb";
  const std::string baseline = !voltage ? " --baseline W" : friction ? " --baseline V0" : "";
  out << "\n## Try it\n\nHide it in a case of our own servo, and look for it:\n\n"
      << "    darwinop gap hide --effect " << effect.id << (voltage ? ":2" : "") << baseline << " --out /tmp/"
      << effect.id << "\n    darwinop gap run /tmp/" << effect.id << "/cases/hidden\n";
}

std::string page(const EffectInfo& effect) {
  std::ostringstream out;
  out << "# " << effect.id << ": " << effect.title << "\n\n"
      << "Generated from `twin/effects/" << effect.id << ".cpp` by `" << kHowToRenew << "`; do not edit.\n\n"
      << "    " << effect.equation << "\n\n"
      << "Acts on: " << twin::name(effect.place) << ". Symbols: [the catalogue](../../twin/effects.md). Looked for "
      << lookedFor(effect) << ".\n\n";
  printParameters(out, effect);
  out << "\n## In logs\n\n" << effect.signature << "\n\n## Taken for\n\n";
  for (const EffectInfo* other : twin::doublesOf(effect)) out << "- " << link(*other) << ": " << other->title << '\n';
  out << "\n## Told apart by\n\n" << effect.separated_by << "\n";
  printTrial(out, effect);
  out << "\n## Source\n\n" << effect.source << '\n';
  return out.str();
}

std::string overview() {
  std::ostringstream out;
  out << "# Effects that darwinop gap can name\n\nGenerated from the files in `twin/effects/` by `" << kHowToRenew
      << "`; do not edit. A page each: equation, parameters,\nwhat it looks like, what it is taken for, and what tells "
         "it apart. [How a verdict is reached](../verdicts.md).\n\n"
      << "| Effect | | Acts on |\n|---|---|---|\n";
  for (const EffectInfo* effect : twin::catalogue())
    out << "| " << link(*effect) << " | " << effect->title << " | " << twin::name(effect->place) << " |\n";
  return out.str();
}

std::map<std::string, std::string> pages() {
  std::map<std::string, std::string> all{{"README.md", overview()}};
  for (const EffectInfo* effect : twin::catalogue()) all[std::string{effect->id} + ".md"] = page(*effect);
  return all;
}

int check(const fs::path& folder) {
  const auto wanted = pages();
  for (const auto& [name, text] : wanted) {
    std::ifstream file{folder / name};
    if (std::string{std::istreambuf_iterator<char>{file}, {}} != text) {
      std::cerr << (folder / name).string() << " is out of date: run `" << kHowToRenew << "` and commit the result\n";
      return 1;
    }
  }
  for (const auto& entry : fs::directory_iterator{folder})
    if (!wanted.contains(entry.path().filename().string())) {
      std::cerr << entry.path().string() << ": there is no such effect any more; delete the page\n";
      return 1;
    }
  return 0;
}

int write(const fs::path& folder) {
  fs::create_directories(folder);
  for (const auto& [name, text] : pages()) std::ofstream{folder / name} << text;
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc == 3 && std::string{argv[1]} == "--check") return check(argv[2]);
  if (argc == 2 && argv[1][0] != '-') return write(argv[1]);
  std::cerr << "usage: " << argv[0] << " [--check] FOLDER\n";
  return 2;
}
