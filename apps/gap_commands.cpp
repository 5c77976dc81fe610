#include "gap_commands.hpp"

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <nlohmann/json.hpp>

#include "gap/benchmark/make/make_case.hpp"
#include "gap/case/body/body_case.hpp"
#include "gap/case/data_check.hpp"
#include "gap/export/semantics.hpp"
#include "gap/export/targets.hpp"
#include "gap/parallel/ranks.hpp"
#include "gap/report/results.hpp"
#include "hal/write_text_file.hpp"

namespace darwinop::gap {
namespace {

namespace fs = std::filesystem;

void write(const std::string& path, const std::string& text) {
  if (Ranks::isFirst()) writeTextFile(path, text);
}

/// "coulomb", "coulomb:2", "stribeck.friction=0.05"; several of the last kind for one effect belong together.
void addTo(std::vector<HiddenEffect>& effects, const std::string& text) {
  const std::size_t end = text.find_first_of(".:");
  const std::string id = text.substr(0, end);
  auto found = std::find_if(effects.begin(), effects.end(), [&](const auto& effect) { return effect.id == id; });
  if (found == effects.end()) found = effects.insert(effects.end(), HiddenEffect{.id = id});
  if (end == std::string::npos) return;
  const std::size_t equals = text.find('=');
  try {
    if (text[end] == ':')
      found->severity = std::stoi(text.substr(end + 1));
    else if (equals != std::string::npos)
      found->values[text.substr(end + 1, equals - end - 1)] = std::stod(text.substr(equals + 1));
    else
      throw std::invalid_argument(text);
  } catch (const std::logic_error&) {
    throw std::runtime_error("'" + text +
                             "' is not an effect to hide; write ID, ID:SEVERITY or ID.PARAMETER=VALUE, as in " +
                             "coulomb.friction=0.05");
  }
}

}  // namespace

int check(const Arguments& given) {
  if (isBodyCase(given.folder)) return checkBody(given);
  std::cout << asText(checkData(readGiven(given)));
  return 0;
}

int where(const Arguments& given) {
  if (isBodyCase(given.folder)) return locateBody(given);
  const Case read = readGiven(given);
  printWarnings(read);
  const Localization found = localize(Study{read});
  std::cout << (given.json ? asJson(found).dump(1) + "\n" : asText(found));
  return 0;
}

int hideEffects(const Arguments& given) {
  CaseRequest request;
  request.seed = given.seed;
  request.wrong_numbers = given.wrong_numbers;
  request.name = given.name;
  for (const Baseline baseline : {Baseline::kFrictionless, Baseline::kFriction, Baseline::kSpeed, Baseline::kFine})
    if (nameOf(baseline) == given.baseline) request.baseline = baseline;
  if (nameOf(request.baseline) != given.baseline)
    throw std::runtime_error("there is no baseline '" + given.baseline + "'; there are V0, CV, W and F");
  for (const std::string& effect : given.effects) addTo(request.effects, effect);
  hide(request, given.out);
  std::cerr << "darwinop gap: " << (fs::path{given.out} / "cases" / request.name).string() << " is the case, "
            << (fs::path{given.out} / "key.json").string() << " has its effects\n";
  return 0;
}

int writeFor(const Arguments& given) {
  const std::optional<Target> target = targetFrom(given.target);
  if (!target) throw std::runtime_error("there is no target '" + given.target + "'; there are webots, mujoco and urdf");
  if (isBodyCase(given.folder)) return writeBodyFor(given);
  const Case read = readGiven(given);
  const ExportSettings settings = settingsFor(read);
  const Hypothesis model = baselineOf(read);
  const Export made = exportTo(*target, model, settings);
  if (given.out.empty())
    std::cout << made.text;
  else
    write(given.out, made.text);
  for (const std::string& lost : made.lost) std::cerr << "lost: " << lost << '\n';
  for (const std::string& approximated : made.approximated) std::cerr << "approximated: " << approximated << '\n';
  std::cerr << asText(remeasure(*target, read, model, settings));
  return 0;
}

}  // namespace darwinop::gap
