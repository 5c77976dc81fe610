// darwinop-experiment: lists, shows, runs and plots experiments.
#include <time.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cctype>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <iostream>
#include <stdexcept>
#include <string>
#include <webots/Robot.hpp>

#include "connect/robot_file.hpp"
#include "connect/setting.hpp"
#include "experiments/format/experiment_files.hpp"
#include "experiments/format/messages.hpp"
#include "experiments/format/plan.hpp"
#include "experiments/format/reader.hpp"
#include "experiments/run/gentle_stop.hpp"
#include "experiments/run/hardware.hpp"
#include "experiments/run/progress.hpp"
#include "experiments/run/runner.hpp"
#if __has_include("experiments/logs/plot/plot.hpp")
#include "experiments/logs/plot/plot.hpp"
#define DARWINOP_CAN_PLOT
#endif

namespace {

using namespace darwinop::experiments;

// Exit statuses, docs/experiments.md.
constexpr int kDone = 0, kEnded = 1, kWrong = 2, kNeedsYes = 3, kStopped = 130;

struct Arguments {
  std::string experiment, robot, record;
  int period_ms = 0;
  bool yes = false, no_record = false;
};

int list() {
  int status = kDone;
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
      status = kWrong;
    }
  if (files.empty()) throw std::runtime_error("no experiments found in " + experimentFolders().back());
  return status;
}

int show(const std::string& name) {
  const Experiment experiment = readExperiment(findExperiment(name));
  std::cout << planText(experiment, makePlan(experiment, darwinop::safety::hardRanges()));
  return kDone;
}

/// Joint ranges of this robot; robot.ini may narrow them.
Ranges rangesOf(const darwinop::connect::Setting& robot) {
  if (robot.kind != darwinop::connect::RobotKind::kSerial) return darwinop::safety::hardRanges();
  return darwinop::connect::safetyOn(darwinop::connect::readRobotFile(), {}, "config.ini").range;
}

/// "speed-20260102-150405-twin.csv".
std::string logName(const Experiment& experiment, const std::string& robot) {
  char date[32];
  const time_t now = time(nullptr);
  tm local{};
  localtime_r(&now, &local);
  strftime(date, sizeof date, "-%Y%m%d-%H%M%S-", &local);
  std::string name = robot.empty() ? "robot" : std::filesystem::path{robot}.stem().string();
  std::ranges::replace_if(
      name, [](unsigned char c) { return std::isalnum(c) == 0; }, '-');
  return experiment.name + date + name + ".csv";
}

void setIfGiven(const char* name, const std::string& value) {
  if (!value.empty()) setenv(name, value.c_str(), 1);
}

/// On the robot selected by the environment; on return the robot is at rest and the recording complete.
RunOutcome drive(const Experiment& experiment, const Plan& plan) {
  webots::Robot robot;
  const std::atomic<bool>& stop = installGentleStop();
  Progress progress{plan.seconds()};
  const auto report = [&](const std::string& phase, double seconds) { progress.update(phase, seconds); };
  return Runner{robot, experiment, stop, report}.run();
}

int reportEnd(RunOutcome outcome, const std::string& record) {
  if (!record.empty()) std::cout << "recorded: " << record << std::endl;
  switch (outcome) {
    case RunOutcome::kStopped:
      std::cerr << "stopped on request; the recording contains the data until then\n";
      return kStopped;
    case RunOutcome::kEnded:
      std::cerr << "the experiment was ended by the robot, see above\n";
      return kEnded;
    case RunOutcome::kFell:
      std::cerr << "the robot fell before the first pose; nothing was measured. Set it upright on level floor, "
                   "in its start pose, and try again\n";
      return kEnded;
    case RunOutcome::kFellIn:
      std::cerr << "unexpected fall: the experiment was ended, and the recording is invalid from "
                   "the fall on\n";
      return kEnded;
    default:
      return kDone;
  }
}

int run(Arguments a) {
  const Experiment experiment = readExperiment(findExperiment(a.experiment));
  if (const char* usual = std::getenv("DARWINOP_ROBOT"); a.robot.empty() && usual != nullptr) a.robot = usual;
  const darwinop::connect::Setting robot = darwinop::connect::readSetting(a.robot);
  const Plan plan = makePlan(experiment, rangesOf(robot));
  std::cout << planText(experiment, plan) << std::endl;
  if (!a.yes && mayBeHardware(a.robot)) {
    std::cerr << "darwinop experiment: this moves a real robot, as shown above. Make sure that nothing is in its way "
                 "and that "
                 "a person holds it, then add --yes\n";
    return kNeedsYes;
  }
  if (darwinop::connect::loopIsElsewhere(robot) && !a.no_record)
    throw std::runtime_error(
        "the loop of this robot runs in the daemon, which writes recordings itself: start it with darwinop runtime "
        "--record FILE, and run the experiment with --no-record");
  if (a.record.empty() && !a.no_record) a.record = logName(experiment, a.robot);
  setIfGiven("DARWINOP_ROBOT", a.robot);
  if (a.period_ms != 0) setIfGiven("DARWINOP_PERIOD_MS", std::to_string(a.period_ms));
  unsetenv("DARWINOP_RECORD");
  setIfGiven("DARWINOP_RECORD", a.record);
  setIfGiven("DARWINOP_RECORD_NOTES", recordNotes(experiment));
  setenv("DARWINOP_KEEP_CWD", "1", 1);  // file names are relative to the user's folder
  return reportEnd(drive(experiment, plan), a.record);
}

void describeRun(CLI::App& app, Arguments& a) {
  app.add_option("EXPERIMENT", a.experiment, "name of an included experiment, or a file: ./mine.ini")->required();
  app.add_option(
      "--robot", a.robot,
      "robot; default: DARWINOP_ROBOT, or else the first one found:\n" + darwinop::connect::settingChoices());
  app.add_option("--record", a.record, "recording; default: NAME-DATE-ROBOT.csv in this folder");
  app.add_flag("--no-record", a.no_record, "do not record")->excludes("--record");
  app.add_option("--period", a.period_ms, "period of the loop in ms, 16 or 8")->check(CLI::Range(1, 1000));
  app.add_flag("--yes", a.yes, "permit moving a real robot");
  app.footer("Exit status: 0 done, 1 ended by the robot, 2 invalid file or arguments, 3 needs --yes, 130 Ctrl-C");
}

#ifdef DARWINOP_CAN_PLOT
void describePlot(CLI::App& app, darwinop::plot::PlotOptions& options) {
  app.add_option("LOG", options.logs, "recordings to overlay")->required()->check(CLI::ExistingFile);
  app.add_option("-o,--output", options.output, "output name without extension; default: the first log's name");
  app.add_option("--columns", options.columns, "columns to plot, with wildcards * and ?")->delimiter(',');
  app.add_option("--x", options.x, "column for the x axis; default: time");
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
  Arguments a;
  CLI::App& lists = *app.add_subcommand("list", "list the included experiments: joints, amplitudes, durations");
  CLI::App& shows = *app.add_subcommand("show", "show the steps of an experiment without moving");
  shows.add_option("EXPERIMENT", a.experiment, "name or file")->required();
  CLI::App& runs = *app.add_subcommand("run", "show, check and run an experiment");
  describeRun(runs, a);
#ifdef DARWINOP_CAN_PLOT
  darwinop::plot::PlotOptions options;
  CLI::App& plots = *app.add_subcommand("plot", "plot recordings as PNG and HTML");
  describePlot(plots, options);
#else
  CLI::App& plots = *app.add_subcommand("plot", "plot recordings; on a PC only")->allow_extras();
#endif
  try {
    app.parse(count, arguments);
  } catch (const CLI::ParseError& mistake) {
    return app.exit(mistake) == 0 ? 0 : kWrong;
  }
  if (lists.parsed()) return list();
  if (shows.parsed()) return show(a.experiment);
#ifdef DARWINOP_CAN_PLOT
  if (plots.parsed()) return darwinop::plot::plotCommand(options);
#else
  if (plots.parsed())
    throw std::runtime_error(
        "plotting is available on a PC only: copy the recording there and run darwinop experiment plot FILE");
#endif
  return run(a);
}

}  // namespace

int main(int count, char** arguments) {
  try {
    return command(count, arguments);
  } catch (const std::exception& error) {
    std::cerr << "darwinop experiment: " << error.what() << '\n';
    return kWrong;
  }
}
