// What was found in a whole robot, as changes of its model file.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "gap/report/addition.hpp"
#include "twin/model/model.hpp"

namespace darwinop::gap {

struct BodyAdditions {
  Additions additions;
  std::vector<std::string> left_out;  // sentences: what the model has already and cannot have twice
};

/// From what `run` wrote of the case `name`: report.json, or results.json of a benchmark. `model`: that they go into.
/// Throws std::runtime_error, a sentence, for a result that names nothing.
BodyAdditions bodyAdditionsIn(std::string_view results, const std::string& file, const std::string& name,
                              const twin::Model& model);

/// Key of the hash of the model file that a search was on.
inline constexpr const char* kModelHash = "model_sha256";
/// A warning if that was another one than `model`; empty: the same, or an older version wrote the result, without hash.
std::string otherModelWarning(std::string_view results, const std::string& file, const std::string& name,
                              std::string_view model);

}  // namespace darwinop::gap
