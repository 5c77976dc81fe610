// `darwinop experiment plot`: draws curves of one or several logs as NAME.png and NAME.html; docs/plots.md.
#pragma once

#include <string>
#include <vector>

namespace darwinop::plot {

struct PlotOptions {
  std::vector<std::string> logs;     // recordings or plain CSV files; overlaid
  std::string output;                // -o: path without extension; empty: the first log's without ".csv"
  std::vector<std::string> columns;  // --columns: patterns, * any text, ? one character; empty: default curves
  std::string x;                     // --x: column of the horizontal axis; empty: time from the start of each log
};

/// Writes both files and prints their names to stdout, warnings to stderr. Returns 0, or 1 if only the HTML file was
/// written because gnuplot failed. Throws std::runtime_error if there is nothing to plot.
int plotCommand(const PlotOptions& options);

}  // namespace darwinop::plot
