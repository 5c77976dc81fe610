// Builds a figure from logs: choice of the plot, axes, labels.
#include "experiments/logs/plot/make_figure.hpp"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <set>
#include <stdexcept>
#include <string_view>

#include "experiments/logs/plot/choice.hpp"
#include "experiments/logs/plot/experiment_plot.hpp"
#include "experiments/logs/plot/messages.hpp"
#include "experiments/logs/plot/text.hpp"
#include "experiments/logs/plot/traces.hpp"

namespace darwinop::plot {
namespace {

Source sourceOf(const logs::Log& log) {
  const auto head = [&](const char* key) { return oneLine(log.headValue(key).value_or("")); };
  return {"", oneLine(log.file), head("robot"), head("model"), head("version"), head("date")};
}

/// The last `parts` components of a path, without ".csv": "e01/fit_1".
std::string tail(const std::string& file, int parts) {
  std::filesystem::path rest = std::filesystem::path{file}.lexically_normal();
  std::string name = rest.extension() == ".csv" ? rest.stem().string() : rest.filename().string();
  for (rest = rest.parent_path(); parts > 1 && rest.has_filename(); rest = rest.parent_path(), --parts)
    name.insert(0, rest.filename().string() + "/");
  return name;
}

bool allDiffer(const std::vector<Source>& sources, std::string Source::*part) {
  std::set<std::string> values;
  for (const Source& source : sources) values.insert(source.*part);
  return values.size() == sources.size();
}

/// Shortest labels that distinguish the logs, with the model if it differs and all labels fit.
std::vector<Source> sourcesOf(const std::vector<logs::Log>& all) {
  std::vector<Source> sources;
  std::transform(all.begin(), all.end(), std::back_inserter(sources), sourceOf);
  constexpr int kMaxParts = 4;
  for (int parts = 1; parts <= kMaxParts; ++parts) {
    for (Source& source : sources) source.label = tail(source.file, parts);
    if (allDiffer(sources, &Source::label)) break;
  }
  if (!allDiffer(sources, &Source::label))
    for (std::size_t i = 0; i < sources.size(); ++i) sources[i].label += " #" + std::to_string(i + 1);
  constexpr std::size_t kAvailable = kLegend - std::string_view{" (), goal"}.size();
  const bool fits = std::all_of(sources.begin(), sources.end(),
                                [&](const Source& s) { return s.label.size() + s.model.size() <= kAvailable; });
  if (sources.size() > 1 && fits && allDiffer(sources, &Source::model))
    for (Source& source : sources)
      if (!source.model.empty()) source.label += " (" + source.model + ")";
  return sources;
}

bool sameExperiment(const std::vector<logs::Log>& all) {
  return std::all_of(all.begin(), all.end(), [&](const logs::Log& log) {
    return log.headValue("experiment") == all.front().headValue("experiment");
  });
}

std::string titleOf(const std::vector<logs::Log>& all, const std::vector<Source>& sources) {
  if (const auto experiment = all.front().headValue("experiment"); experiment && sameExperiment(all))
    return oneLine(*experiment);
  std::string title;
  for (const Source& source : sources) title.append(title.empty() ? "" : ", ").append(source.label);
  return shortened(title, 100);
}

bool empty(const Figure& figure) {
  return std::all_of(figure.panels.begin(), figure.panels.end(), [](const Panel& p) { return p.curves.empty(); });
}

bool drawExperimentPlot(const std::vector<logs::Log>& all, Figure& figure) {
  const ExperimentPlot* plot = experimentPlot(all.front());
  if (plot == nullptr || !sameExperiment(all)) return false;
  std::vector<std::vector<LogCurve>> pieces;
  for (const logs::Log& log : all) {
    pieces.push_back(plot->curves(log));
    if (pieces.back().empty())
      figure.notes.push_back(oneLine(log.file) + " lacks data for this plot: " + std::string{plot->title});
  }
  figure.panels = panelsOf(std::move(pieces), figure.sources);
  if (empty(figure)) return false;  // fall back to the default curves
  figure.title += ": " + std::string{plot->title};
  figure.x_label = plot->x_label;
  return true;
}

void drawCurves(const std::vector<logs::Log>& all, const PlotOptions& options, Figure& figure) {
  const bool chosen = !options.columns.empty();
  checkPatterns(all, options.columns);
  const auto joints = chosen ? std::vector<std::string>{} : movingJoints(all, figure.notes);
  std::vector<std::vector<LogCurve>> pieces;
  for (const logs::Log& log : all) {
    const std::vector<double> x = options.x.empty() ? timeFrom(log, startRow(log)) : log.column(options.x).values;
    pieces.push_back(chosen ? selectedCurves(log, x, options.columns) : defaultCurves(log, x, joints));
  }
  figure.panels = panelsOf(std::move(pieces), figure.sources);
  if (const auto title = all.front().headValue("title"); title && sameExperiment(all))
    figure.title += ": " + oneLine(*title);
  figure.x_label = "time [s]";
  if (!options.x.empty()) figure.x_label = oneLine(withUnit(options.x, all.front().column(options.x).unit));
  if (empty(figure))
    throw std::runtime_error(options.logs.front() +
                             (!chosen ? std::string{": "} + messages::kNothingMoves +
                                            "; choose curves with --columns, as in --columns 'Neck.*'"
                                      : ": the requested columns have no value in any row"));
}

}  // namespace

Figure makeFigure(const std::vector<logs::Log>& all, const PlotOptions& options) {
  for (const logs::Log& log : all)
    if (log.rows() == 0) throw std::runtime_error(log.file + " has no rows; record the log again");
  Figure figure;
  figure.sources = sourcesOf(all);
  figure.title = titleOf(all, figure.sources);
  for (const logs::Log& log : all)
    for (const std::string& warning : log.warnings) figure.notes.push_back(oneLine(warning));
  const bool has_selection = !options.columns.empty() || !options.x.empty();
  if (has_selection || !drawExperimentPlot(all, figure)) drawCurves(all, options, figure);
  return figure;
}

}  // namespace darwinop::plot
