// A case as files: the inverse of readCase().
#pragma once

#include <string>

#include "gap/case/case.hpp"

namespace darwinop::gap {

/// Makes the folder and writes case.json, a CSV for each log, and model.ini when a `baseline` cannot hold the model.
/// What is read back agrees to nine digits. Throws std::runtime_error when a file cannot be written.
void writeCase(const Case& c, const std::string& folder);

/// The texts of the two files.
std::string caseAsJson(const Case& c, bool with_model_file);
std::string logAsCsv(const Trajectory& log);
/// A `baseline` can represent the whole model.
bool fitsBaseline(const Case& c);

}  // namespace darwinop::gap
