// The body as MuJoCo reads it, made from the tables of facts in twin/models/data.
#pragma once

#include <string>

namespace darwinop::twin {

/// The whole of twin/models/darwin-op.xml. `data` is the folder of the tables. Throws std::runtime_error that names
/// file, line and column.
std::string bodyXml(const std::string& data);

}  // namespace darwinop::twin
