// Generates the MuJoCo body file from the tables in twin/models/data.
#pragma once

#include <string>

namespace darwinop::twin {

/// Text of twin/models/darwin-op.xml. `data`: folder of the tables. Throws std::runtime_error with file, line and
/// column.
std::string bodyXml(const std::string& data);

}  // namespace darwinop::twin
