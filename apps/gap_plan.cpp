// darwinop gap plan: the next experiment.
#include <iostream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "core/json/json_text.hpp"
#include "core/text/number_text.hpp"
#include "core/text/shell_word.hpp"
#include "experiments/format/phase_reader.hpp"
#include "gap/identify/identification.hpp"
#include "gap/plan/body/motion_ranking.hpp"
#include "gap/plan/question.hpp"
#include "gap/plan/write_experiments.hpp"
#include "gap/report/data_hash.hpp"
#include "gap/report/read_results.hpp"
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

int planForBody(const Arguments& given) {
  if (!given.against.empty() || !given.write.empty() || given.hangs_at_rad || !given.joint.empty() ||
      !given.results.empty())
    throw std::runtime_error(
        "--against, --write, --hangs-at, --joint and report.json are for one servo; leave them out for a whole robot");
  const BodyCase read = readBodyCase(given.folder);
  const BodyIdentification found = identify(read);
  if (!given.json)
    std::cerr << "darwinop gap: verdict: " << nameOf(found.verdict) << "\ndarwinop gap: simulating the motions\n";
  const BodyPlan plan = nextMotions(read, questionAfter(read, found), plannedMotions());
  const std::string folder = text::shellWord(given.folder);
  std::cout << (given.json ? jsonText(asJson(plan, folder), 1) + "\n" : asText(plan, folder));
  return 0;
}

namespace {

/// A case of a joint is repeated with that joint.
ArmSetup standFor(const Case& read, const Arguments& given) {
  const Joint joint = read.joint && given.joint.empty() ? *read.joint : experiments::jointNamed(given.jointOrUsual());
  if (read.joint && joint != *read.joint)
    throw std::runtime_error(read.name + " is a case of " + std::string{row(*read.joint).name} +
                             "; leave --joint out, or make a case of the other joint: darwinop gap case");
  return armSetupFor(joint, given.hangs_at_rad);
}

/// As a run has it, or by a search of its own.
Identification identified(const Case& read, const Arguments& given, const ProgressCallback& progress) {
  if (given.results.empty()) {
    IdentifyOptions options;
    options.progress = progress;
    return identify(Study{read}, options);
  }
  const std::string report = textOf(given.results);
  Identification found = identifiedIn(report, given.results, read);
  if (const std::string warning = otherDataWarning(report, given.results, dataHash(read)); !warning.empty())
    progress(warning);
  return found;
}

}  // namespace

int planNext(const Arguments& given) {
  if (isBodyCase(given.folder)) return planForBody(given);
  if (!given.against.empty() && !given.results.empty())
    throw std::runtime_error("report.json and --against both say what is to be separated; leave one of them out");
  const Case read = readCase(given.folder);
  const ArmSetup stand = standFor(read, given);
  const ProgressCallback progress = [&](const std::string& what) {
    if (!given.json) std::cerr << "darwinop gap: " << what << '\n';
  };
  Question question;
  if (given.against.empty()) {
    const Identification identification = identified(read, given, progress);
    progress("verdict: " + std::string{nameOf(identification.verdict)});
    question = questionAfter(read, identification, progress);
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
