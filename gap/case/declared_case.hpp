// A case of raw logs, with what is declared of them.
#pragma once

#include "gap/case/declarations.hpp"
#include "gap/case/parse_case.hpp"
#include "gap/case/raw_folder.hpp"

namespace darwinop::gap {

/// Reads the case `json` with the declared order of goals, axis, part of the logs, zero of the joint, encodings and
/// priors. Logs that cannot be used go to those of `into`. Throws BadInput.
void readDeclared(const std::string& json, const Declarations& declared, CaseFiles files, FolderCase& into);

}  // namespace darwinop::gap
