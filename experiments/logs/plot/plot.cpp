// `darwinop experiment plot`: reads the logs, writes picture and page.
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
  const std::string ending = name.extension().string();
  if (options.output.empty() ? ending == ".csv" : ending == ".png" || ending == ".html") name.replace_extension();
  return name.string();
}

void writeFile(const std::string& path, const std::string& text) {
  std::FILE* file = std::fopen(path.c_str(), "wbe");
  bool written = file != nullptr && std::fwrite(text.data(), 1, text.size(), file) == text.size();
  if (file != nullptr) written = std::fclose(file) == 0 && written;
  if (!written)
    throw std::runtime_error("cannot write " + path + ": " + std::strerror(errno) + "; name another place with -o");
}

}  // namespace

int plotCommand(const PlotOptions& options) {
  if (options.logs.empty()) throw std::runtime_error("which log? name one or several recordings");
  std::vector<logs::Log> all;
  for (const std::string& path : options.logs) all.push_back(logs::readLog(path));
  const Figure figure = makeFigure(all, options);
  for (const std::string& note : figure.notes) std::cerr << "note: " << note << '\n';
  const std::string name = nameOf(options);
  writeFile(name + ".html", htmlPage(figure));
  std::cout << name << ".html\n";
  const std::string missing = drawPicture(figure, name + ".png");
  if (missing.empty())
    std::cout << name << ".png\n";
  else
    std::cerr << missing << '\n';
  return missing.empty() ? 0 : 1;
}

}  // namespace darwinop::plot
