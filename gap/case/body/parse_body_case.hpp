// A case of the whole robot from text, wherever its files come from.
#pragma once

#include "gap/case/body/body_case.hpp"
#include "gap/case/parse_case.hpp"

namespace darwinop::gap {

/// `file`: what errors call the JSON. Throws BadInput.
BodyCase parseBodyCase(std::string_view json, const std::string& file, const CaseFiles& files);

/// Appends the rows of a recording to `log`, and its joints to `joints`. Throws BadInput.
void fillBodyLog(const logs::Log& recording, BodyLog& log, std::vector<Trajectory>& joints);

}  // namespace darwinop::gap
