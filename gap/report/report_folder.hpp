// The folder of a report.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace darwinop::gap {

/// Names and contents, which replace older files. Makes the folder. Throws std::runtime_error with what to do.
void writeReportFolder(const std::string& folder, const std::vector<std::pair<std::string, std::string>>& files);

}  // namespace darwinop::gap
