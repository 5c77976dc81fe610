#include "gap/plan/write_experiments.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <stdexcept>

#include "experiments/format/quantity.hpp"
#include "gap/plan/experiment_text.hpp"
#include "hal/write_text_file.hpp"

namespace darwinop::gap {
namespace {

namespace fs = std::filesystem;

/// The entry of a case.json for the recording. Each P gain is a log of its own: from_s and to_s cut it.
std::string entryFor(const NextExperiments& next, const ExperimentCandidate& candidate) {
  const std::string& name = candidate.experiment.name;
  return "{\"file\": \"" + name + ".csv\", \"role\": \"fit\", \"trajectory\": \"" + name + "\", \"joint\": \"" +
         std::string{row(next.stand.joint).name} +
         "\", \"hangs_at_rad\": " + experiments::shortText(next.stand.hangs_at_rad) +
         ", \"payload_kg\": " + experiments::shortText(candidate.payload_kg) + "}";
}

}  // namespace

std::string commandFor(const std::string& path) {
  return "darwinop experiment run " + path + " --record " + fs::path{path}.stem().string() + ".csv";
}

std::string fileOf(const NextExperiments& next, const Ranked& ranked) {
  const ExperimentCandidate& candidate = ranked.vetted.candidate;
  std::vector<std::string> comments{"By darwinop gap plan. " + sentenceOf(next.question, ranked) + "."};
  if (!candidate.prepare.empty()) comments.push_back("First: " + candidate.prepare + ".");
  for (const std::string& cut : ranked.vetted.cuts) comments.push_back("Shortened: " + cut + ".");
  comments.push_back("Its recording in a case.json, docs/gap/plan.md: " + entryFor(next, candidate));
  return experimentText(candidate.experiment, comments);
}

std::vector<std::string> writeBest(const NextExperiments& next, const std::string& folder, std::size_t most) {
  std::error_code failed;
  fs::create_directories(folder, failed);
  if (failed) throw std::runtime_error("cannot create " + folder + ": " + failed.message());
  std::vector<std::string> paths;
  for (std::size_t i = 0; i < std::min(most, next.ranked.size()); ++i) {
    paths.push_back((fs::path{folder} / (next.ranked[i].vetted.candidate.experiment.name + ".ini")).string());
    writeTextFile(paths.back(), fileOf(next, next.ranked[i]));
  }
  return paths;
}

}  // namespace darwinop::gap
