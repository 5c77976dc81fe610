// results.json of `darwinop gap benchmark run`: a list with one object for each case.
#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <string>

namespace darwinop::gap {

/// Calls `take` with each case's name and object. Throws std::runtime_error, a sentence with the file and, where it is
/// known, the case: for a file that is not such a list, a case that is there twice, and whatever `take` throws.
void forEachResult(const std::string& path,
                   const std::function<void(const std::string& name, const nlohmann::ordered_json& result)>& take);

/// NaN: there is none, or it is no number.
double numberIn(const nlohmann::ordered_json& object, const char* name);

}  // namespace darwinop::gap
