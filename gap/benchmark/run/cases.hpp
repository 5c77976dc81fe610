// The cases of a folder.
#pragma once

#include <string>
#include <vector>

namespace darwinop::gap {

struct CaseFolder {
  std::string name, path, fingerprint;
};

/// By name. Throws std::runtime_error, a sentence, where there is none.
std::vector<CaseFolder> casesIn(const std::string& folder);

}  // namespace darwinop::gap
