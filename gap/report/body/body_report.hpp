// Report of a whole robot: HTML page, report.json, repaired.ini.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "gap/identify/body/body_identification.hpp"

namespace darwinop::gap {

struct BodyReport {  // NOLINT(bugprone-exception-escape): no constructor of the JSON library throws
  const BodyCase* given = nullptr;
  const BodyIdentification* found = nullptr;
  nlohmann::ordered_json answer;  // as `run --json` has it
  std::string model_before, model_after;
  std::vector<std::string> left_out;  // of the model: sentences
  std::vector<std::string> commands;  // that make this report again
};

/// Hash of case.json and the recordings, each once, in the order of the case: as data_hash.hpp.
std::string dataHash(const BodyCase& given);

/// Both have to outlive it. `model`: the file that the case's model is from, whose comments stay.
BodyReport reportOf(const BodyCase& given, const BodyIdentification& found, const std::string& model);

/// A signal that no named effect explains, and the block of the loop that it is of.
struct OpenSignal {
  std::string signal, block;
};
std::vector<OpenSignal> openSignals(const BodyReport& report);

/// As report.json has it: the same for the same recordings, so without the time of the search.
nlohmann::ordered_json asJson(const BodyReport& report);

/// One file that needs no other and no network.
std::string asHtml(const BodyReport& report);

/// Makes `folder`. Throws std::runtime_error with a sentence when a file cannot be written.
void writeReport(const BodyReport& report, const std::string& folder);

}  // namespace darwinop::gap
