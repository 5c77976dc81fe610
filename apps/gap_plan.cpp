// darwinop gap plan: the most informative next experiment.
#include <iostream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "core/text/number_text.hpp"
#include "experiments/format/phase_reader.hpp"
#include "gap/name/naming.hpp"
#include "gap/plan/ask.hpp"
#include "gap/plan/hand_over.hpp"
#include "gap_commands.hpp"

namespace darwinop::gap {
namespace {

std::vector<std::string> partsOf(const std::string& list) {
  std::vector<std::string> parts;
  std::istringstream text{list};
  for (std::string part; std::getline(text, part, ',');) {
    const std::string_view id = text::withoutBlanks(part);
    if (id.empty()) throw std::runtime_error("--against " + list + ": an id is missing between two commas");
    parts.emplace_back(id);
  }
  return parts;
}

}  // namespace

int planNext(const Arguments& given) {
  const Case read = readCase(given.folder);
  const Stand stand = standOf(experiments::jointNamed(given.joint), given.hangs_at_rad);
  const Tell progress = [&](const std::string& what) {
    if (!given.json) std::cerr << "darwinop gap: " << what << '\n';
  };
  Question question;
  if (given.against.empty()) {
    NameOptions options;
    options.tell = progress;
    const Naming naming = nameEffects(read, options);
    progress("verdict: " + std::string{nameOf(naming.verdict)});
    question = questionAfter(read, naming, progress);
  } else {
    question = questionBetween(read, partsOf(given.against), progress);
  }
  progress("simulating the experiments");
  const NextExperiments next = nextExperiments(read, stand, std::move(question), candidatesFor(read, stand));
  std::vector<std::string> paths;
  if (!given.write.empty()) paths = writeBest(next, given.write);
  if (given.json) {
    nlohmann::json out = asJson(next);
    for (const std::string& path : paths) out["written"].push_back({{"file", path}, {"run", commandFor(path)}});
    std::cout << out.dump(1) << '\n';
    return 0;
  }
  std::cout << asText(next);
  if (!paths.empty()) std::cout << "Run one, the best first:\n";
  for (const std::string& path : paths) std::cout << "  " << commandFor(path) << '\n';
  return 0;
}

}  // namespace darwinop::gap
