// The folder of a report.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace darwinop::gap {

/// Names and contents. A file that is there with other contents, as of another case of this name, becomes NAME.before.
/// Makes the folder. Throws std::runtime_error with what to do.
void writeReportFolder(const std::string& folder, const std::vector<std::pair<std::string, std::string>>& files);

}  // namespace darwinop::gap
