// `darwinop experiment plot`: reads the logs, writes PNG and HTML.
#include "experiments/logs/plot/plot.hpp"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <iostream>
#include <stdexcept>

#include "experiments/logs/plot/gnuplot.hpp"
#include "experiments/logs/plot/make_figure.hpp"
#include "experiments/logs/plot/page.hpp"
#include "experiments/logs/read_log.hpp"

namespace darwinop::plot {
namespace {

std::string nameOf(const PlotOptions& options) {
  std::filesystem::path name{options.output.empty() ? options.logs.front() : options.output};
  const std::string extension = name.extension().string();
  if (options.output.empty() ? extension == ".csv" : extension == ".png" || extension == ".html")
    name.replace_extension();
  return name.string();
}

}  // namespace

int plotCommand(const PlotOptions& options) {
  if (options.logs.empty()) throw std::runtime_error("no log given; name one or several recordings");
  std::vector<logs::Log> all;
  for (const std::string& path : options.logs) all.push_back(logs::readLog(path));
  const Figure figure = makeFigure(all, options);
  for (const std::string& note : figure.notes) std::cerr << "note: " << note << '\n';
  const std::string name = nameOf(options);
  std::string missing;
  try {
    writeTextFile(name + ".html", htmlPage(figure));
    std::cout << name << ".html\n";
    missing = drawPicture(figure, name + ".png");
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(std::string{error.what()} + "; choose another path with -o");
  }
  if (missing.empty())
    std::cout << name << ".png\n";
  else
    std::cerr << missing << '\n';
  return missing.empty() ? 0 : 1;
}

}  // namespace darwinop::plot
