// A case from text, wherever its files come from.
#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "experiments/logs/log.hpp"
#include "gap/case/case.hpp"

namespace darwinop::gap {

/// Where the files that a case names come from. Both may throw std::runtime_error, a sentence with the file's name.
struct CaseFiles {
  std::function<logs::Log(const std::string& name)> log;
  std::function<twin::Model(const std::string& name)> model;
};

/// `file`: what errors call the JSON. Throws BadInput.
Case parseCase(std::string_view json, const std::string& file, const CaseFiles& files);

}  // namespace darwinop::gap
