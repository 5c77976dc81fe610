// From logs to a figure: whose plot it is, what the axis shows, how each log is called.
#include "experiments/logs/plot/make_figure.hpp"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <set>
#include <stdexcept>
#include <string_view>

#include "experiments/logs/plot/choice.hpp"
#include "experiments/logs/plot/natural.hpp"
#include "experiments/logs/plot/text.hpp"
#include "experiments/logs/plot/traces.hpp"

namespace darwinop::plot {
namespace {

Source sourceOf(const logs::Log& log) {
  const auto head = [&](const char* key) { return oneLine(log.headValue(key).value_or("")); };
  return {"", oneLine(log.file), head("robot"), head("model"), head("version"), head("date")};
}

/// The last `parts` names of a path, without ".csv": "e01/fit_1".
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

/// Names as short as they can be while they tell the logs apart; beside them the model, when that differs and there is
/// room for all of them.
std::vector<Source> sourcesOf(const std::vector<logs::Log>& all) {
  std::vector<Source> sources;
  std::transform(all.begin(), all.end(), std::back_inserter(sources), sourceOf);
  constexpr int kMostParts = 4;
  for (int parts = 1; parts <= kMostParts; ++parts) {
    for (Source& source : sources) source.label = tail(source.file, parts);
    if (allDiffer(sources, &Source::label)) break;
  }
  if (!allDiffer(sources, &Source::label))
    for (std::size_t i = 0; i < sources.size(); ++i) sources[i].label += " #" + std::to_string(i + 1);
  constexpr std::size_t kSpare = kLegend - std::string_view{" (), goal"}.size();
  const bool room = std::all_of(sources.begin(), sources.end(),
                                [&](const Source& s) { return s.label.size() + s.model.size() <= kSpare; });
  if (sources.size() > 1 && room && allDiffer(sources, &Source::model))
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

bool drawNatural(const std::vector<logs::Log>& all, Figure& figure) {
  const NaturalPlot* plot = naturalPlot(all.front());
  if (plot == nullptr || !sameExperiment(all)) return false;
  std::vector<std::vector<Piece>> pieces;
  for (const logs::Log& log : all) {
    pieces.push_back(plot->pieces(log));
    if (pieces.back().empty())
      figure.notes.push_back(oneLine(log.file) + " does not show what this plot needs: " + std::string{plot->title});
  }
  figure.panels = panelsOf(std::move(pieces), figure.sources);
  if (empty(figure)) return false;  // the usual curves tell at least what happened
  figure.title += ": " + std::string{plot->title};
  figure.x_label = plot->x_label;
  return true;
}

void drawUsual(const std::vector<logs::Log>& all, const PlotOptions& options, Figure& figure) {
  const bool chosen = !options.columns.empty();
  checkPatterns(all, options.columns);
  const auto joints = chosen ? std::vector<std::string>{} : movingJoints(all, figure.notes);
  std::vector<std::vector<Piece>> pieces;
  for (const logs::Log& log : all) {
    const std::vector<double> x = options.x.empty() ? timeFrom(log, startRow(log)) : log.column(options.x).values;
    pieces.push_back(chosen ? chosenPieces(log, x, options.columns) : usualPieces(log, x, joints));
  }
  figure.panels = panelsOf(std::move(pieces), figure.sources);
  if (const auto title = all.front().headValue("title"); title && sameExperiment(all))
    figure.title += ": " + oneLine(*title);
  figure.x_label = "time [s]";
  if (!options.x.empty()) figure.x_label = oneLine(withUnit(options.x, all.front().column(options.x).unit));
  if (empty(figure))
    throw std::runtime_error(options.logs.front() +
                             (!chosen ? ": no joint moves and no sensor changes; choose curves with --columns, as in "
                                        "--columns 'Neck.*'"
                                      : ": the columns asked for have no value in any row"));
}

}  // namespace

Figure makeFigure(const std::vector<logs::Log>& all, const PlotOptions& options) {
  for (const logs::Log& log : all)
    if (log.rows() == 0) throw std::runtime_error(log.file + " has no rows: nothing was recorded");
  Figure figure;
  figure.sources = sourcesOf(all);
  figure.title = titleOf(all, figure.sources);
  for (const logs::Log& log : all)
    for (const std::string& warning : log.warnings) figure.notes.push_back(oneLine(warning));
  const bool as_asked = !options.columns.empty() || !options.x.empty();
  if (as_asked || !drawNatural(all, figure)) drawUsual(all, options, figure);
  return figure;
}

}  // namespace darwinop::plot
