// darwinop-experiment: lists, shows, runs and plots experiments.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <iostream>
#include <stdexcept>
#include <string>
#include <utility>

#include "connect/setting.hpp"
#include "experiment_run.hpp"
#include "experiments/format/experiment_files.hpp"
#include "experiments/format/messages.hpp"
#include "experiments/format/plan.hpp"
#include "experiments/format/reader.hpp"
#include "parse_arguments.hpp"
#include "run_tool.hpp"
#include "safety/config.hpp"
#if __has_include("experiments/logs/plot/plot.hpp")
#include "experiments/logs/plot/plot.hpp"
#define DARWINOP_CAN_PLOT
#endif

namespace {

using namespace darwinop::experiments;

int list() {
  int status = darwinop::app::kDone;
  const std::vector<std::string> files = experimentFiles();
  for (const std::string& file : files) try {
      const Experiment experiment = readExperiment(file);
      const Plan plan = makePlan(experiment, darwinop::safety::hardRanges());
      std::printf("%s\n  %s%s%s\n  %s\n  %.0f s at most%s\n", experiment.name.c_str(), experiment.title.c_str(),
                  experiment.source.empty() ? "" : ", ", experiment.source.c_str(), movedText(plan).c_str(),
                  plan.seconds(),
                  plan.falls     ? messages::kFallsInList
                  : plan.on_feet ? ", on its feet"
                                 : "");
    } catch (const std::exception& wrong) {
      std::cerr << "darwinop experiment: " << wrong.what() << '\n';
      status = darwinop::app::kWrong;
    }
  if (files.empty()) throw std::runtime_error("no experiments found in " + experimentFolders().back());
  return status;
}

int show(const std::string& name) {
  const Experiment experiment = readExperiment(findExperiment(name));
  std::cout << planText(experiment, makePlan(experiment, darwinop::safety::hardRanges()));
  return darwinop::app::kDone;
}

void describeRun(CLI::App& app, ExperimentRequest& a) {
  app.add_option("EXPERIMENT", a.experiment, "name of an included experiment, or a file: ./mine.ini")->required();
  app.add_option(
      "--robot", a.robot,
      "robot; default: DARWINOP_ROBOT, or else the first one found:\n" + darwinop::connect::settingChoices());
  app.add_option("--record", a.record, "recording; default: NAME-DATE-ROBOT.csv in this folder");
  app.add_flag("--no-record", a.no_record, "do not record")->excludes("--record");
  app.add_flag("--allow-clamped", a.allows_clamped, "exit with 0 also if the robot's limits clamp goals");
  app.add_option("--period", a.period_ms, "period of the loop in ms, 16 or 8")->check(CLI::Range(1, 1000));
  app.add_flag("--yes", a.yes, "permit moving a real robot");
  app.footer(
      "Example:\n  darwinop experiment run speed --robot virtual\n"
      "Exit code: 0 done; 1 ended by the robot, a fall, or an incomplete recording; 2 wrong file, arguments or robot: "
      "nothing moved; 3 needs --yes; 130 Ctrl-C");
}

#ifdef DARWINOP_CAN_PLOT
void describePlot(CLI::App& app, darwinop::plot::PlotOptions& options) {
  app.add_option("LOG", options.logs, "recordings to overlay")->required()->check(CLI::ExistingFile);
  app.add_option("-o,--output", options.output, "output name without extension; default: the first log's name");
  app.add_option("--columns", options.columns, "columns to plot, with wildcards * and ?")->delimiter(',');
  app.add_option("--x", options.x, "column for the x axis; default: time");
  app.footer("Example:\n  darwinop experiment plot twin.csv robot.csv -o compare");
}
#endif

int command(int count, char** arguments) {
  CLI::App app{
      "Runs experiment files (motion and recording) on the twin, on a virtual "
      "robot and on a robot. docs/experiments.md",
      "darwinop experiment"};
  app.set_version_flag("--version", DARWINOP_VERSION);
  app.require_subcommand(1);
  app.footer("Example:\n  darwinop experiment run speed --robot virtual");
  ExperimentRequest a;
  CLI::App& lists = *app.add_subcommand("list", "list the included experiments: joints, amplitudes, durations");
  CLI::App& shows = *app.add_subcommand("show", "show the steps of an experiment without moving");
  shows.add_option("EXPERIMENT", a.experiment, "name or file")->required();
  lists.footer("Example:\n  darwinop experiment list");
  shows.footer("Example:\n  darwinop experiment show speed");
  CLI::App& runs = *app.add_subcommand("run", "show, check and run an experiment");
  describeRun(runs, a);
#ifdef DARWINOP_CAN_PLOT
  darwinop::plot::PlotOptions options;
  CLI::App& plots = *app.add_subcommand("plot", "plot recordings as PNG and HTML");
  describePlot(plots, options);
#else
  CLI::App& plots = *app.add_subcommand("plot", "plot recordings; on a PC only")->allow_extras();
#endif
  if (const auto code = darwinop::app::parseArguments(app, count, arguments)) return *code;
  if (lists.parsed()) return list();
  if (shows.parsed()) return show(a.experiment);
#ifdef DARWINOP_CAN_PLOT
  if (plots.parsed()) return darwinop::plot::plotCommand(options);
#else
  if (plots.parsed())
    throw std::runtime_error(
        "plotting is available on a PC only: copy the recording there and run darwinop experiment plot FILE");
#endif
  return run(std::move(a));
}

}  // namespace

int main(int count, char** arguments) {
  return darwinop::app::runTool("darwinop experiment", [&] { return command(count, arguments); });
}
