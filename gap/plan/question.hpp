// The question for the next experiment, from an identification.
#pragma once

#include "gap/identify/identification.hpp"
#include "gap/plan/ranking.hpp"

namespace darwinop::gap {

using ProgressCallback = std::function<void(const std::string&)>;

/// Rivals that the data do not distinguish; else, when nothing was found, the effects that these data cannot show;
/// else the parameter with the widest interval.
Question questionAfter(const Case& given, const Identification& identification, const ProgressCallback& progress);

/// These effects, each fitted alone; or one, against nothing missing.
Question questionBetween(const Case& given, const std::vector<std::string>& ids, const ProgressCallback& progress);

}  // namespace darwinop::gap
