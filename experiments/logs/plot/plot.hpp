// `darwinop experiment plot`: the curves of one or several logs as NAME.png and NAME.html, docs/plots.md.
#pragma once

#include <string>
#include <vector>

namespace darwinop::plot {

struct PlotOptions {
  std::vector<std::string> logs;     // recordings or plain CSV files; laid over each other
  std::string output;                // -o: name without ending; empty: the first log's name without ".csv"
  std::vector<std::string> columns;  // --columns: patterns, * any text, ? one letter; empty: what suits the log
  std::string x;                     // --x: column of the horizontal axis; empty: time from the start of each log
};

/// Writes both files and says so on stdout; warnings on stderr. 0: both are there; 1: the page only, as gnuplot
/// cannot draw the picture. Throws std::runtime_error with a sentence when there is nothing to plot.
int plotCommand(const PlotOptions& options);

}  // namespace darwinop::plot
