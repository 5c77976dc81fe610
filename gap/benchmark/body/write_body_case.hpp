// A case of the whole robot to files: case.json and a recording for each log.
#pragma once

#include <string>

#include "gap/case/body/body_case.hpp"

namespace darwinop::gap {

/// Throws std::runtime_error, a sentence with the file.
void writeBodyCase(const BodyCase& given, const std::string& folder);

}  // namespace darwinop::gap
