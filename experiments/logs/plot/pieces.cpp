// Groups the curves of one or several logs into panels.
#include "experiments/logs/plot/pieces.hpp"

#include <algorithm>

#include "experiments/logs/plot/text.hpp"

namespace darwinop::plot {
namespace {

std::size_t indexOf(std::vector<std::string>& names, const std::string& name) {
  const auto found = std::find(names.begin(), names.end(), name);
  if (found != names.end()) return static_cast<std::size_t>(found - names.begin());
  names.push_back(name);
  return names.size() - 1;
}

}  // namespace

std::vector<Panel> panelsOf(std::vector<std::vector<LogCurve>> curves_of_logs, const std::vector<Source>& sources) {
  const bool several = curves_of_logs.size() > 1;
  std::vector<Panel> panels;
  std::vector<std::string> titles;
  std::vector<std::vector<std::string>> quantities;  // per panel, in the order of their colours
  for (std::size_t log = 0; log < curves_of_logs.size(); ++log) {
    for (LogCurve& item : curves_of_logs[log]) {
      const std::size_t at = indexOf(titles, several ? item.quantity : item.group);
      if (at == panels.size()) {
        panels.push_back({oneLine(titles[at]), oneLine(item.y_label), {}});
        quantities.emplace_back();
      }
      item.curve.log = log;
      item.curve.colour = several ? log : indexOf(quantities[at], item.quantity);
      item.curve.label = several ? sources[log].label + (item.curve.dashed ? ", goal" : "") : oneLine(item.name);
      panels[at].curves.push_back(std::move(item.curve));
    }
  }
  return panels;
}

}  // namespace darwinop::plot
