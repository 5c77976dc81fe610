// The parts of the page, each as HTML.
#pragma once

#include <string>

#include "gap/report/report.hpp"

namespace darwinop::gap {

std::string verdictSection(const Report& report);
std::string headlineSection(const Report& report);
std::string whatSection(const Report& report);
std::string whereSection(const Report& report);
std::string logsSection(const Report& report);
std::string modelSection(const std::string& model_before, const std::string& model_after);
std::string againSection(const Report& report);

/// Of the curves, in JSON: numbers are whole multiples of the units that stand beside them.
std::string curvesAsJson(const Report& report);

}  // namespace darwinop::gap
