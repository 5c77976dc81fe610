// How the curves of one or several logs come together in panels.
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

std::vector<Panel> panelsOf(std::vector<std::vector<Piece>> pieces_of_logs, const std::vector<Source>& sources) {
  const bool several = pieces_of_logs.size() > 1;
  std::vector<Panel> panels;
  std::vector<std::string> titles;
  std::vector<std::vector<std::string>> quantities;  // of each panel, in the order of their colours
  for (std::size_t log = 0; log < pieces_of_logs.size(); ++log) {
    for (Piece& piece : pieces_of_logs[log]) {
      const std::size_t at = indexOf(titles, several ? piece.quantity : piece.group);
      if (at == panels.size()) {
        panels.push_back({oneLine(titles[at]), oneLine(piece.y_label), {}});
        quantities.emplace_back();
      }
      piece.curve.log = log;
      piece.curve.colour = several ? log : indexOf(quantities[at], piece.quantity);
      piece.curve.label = several ? sources[log].label + (piece.curve.dashed ? ", goal" : "") : oneLine(piece.name);
      panels[at].curves.push_back(std::move(piece.curve));
    }
  }
  return panels;
}

}  // namespace darwinop::plot
