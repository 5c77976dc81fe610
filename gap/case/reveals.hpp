// The rules that say what data can reveal.
#pragma once

#include "gap/case/data_check.hpp"

namespace darwinop::gap {

/// One finding a rule; what cannot be seen first.
std::vector<DataFinding> reveals(const DataCheck& check, const Case& c);

}  // namespace darwinop::gap
