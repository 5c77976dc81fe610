// A case from text, wherever its files come from.
#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "experiments/logs/log.hpp"
#include "gap/case/case.hpp"

namespace darwinop::gap {

/// Where the files that a case names come from. Both may throw std::runtime_error, a sentence with the file's name.
struct CaseFiles {
  std::function<logs::Log(const std::string& name)> log;
  std::function<twin::Model(const std::string& name)> model;
  /// Takes what is wrong with a log that is left out of the case; of a case without repeats. Empty: parseCase throws
  /// it. Of raw logs, which are written and read again: false readings are masked then, and stay for now.
  std::function<void(const BadInput& reason)> leave_out = {};
};

/// Files in the folder of a case; a model may also be one of the shipped ones.
CaseFiles filesIn(const std::string& folder);
/// The text of FOLDER/case.json. Throws BadInput.
std::string caseTextIn(const std::string& folder);
/// The log, or BadInput.
logs::Log loadLog(const CaseFiles& files, const std::string& name);

/// `file`: what errors call the JSON. Throws BadInput.
Case parseCase(std::string_view json, const std::string& file, const CaseFiles& files);

}  // namespace darwinop::gap
