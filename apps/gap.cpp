// darwinop-gap: compares simulation with measurement and identifies what is missing from the model.
#include <CLI/CLI.hpp>
#include <exception>
#include <iostream>

#include "gap/sim/parallel.hpp"
#include "gap/sim/ranks.hpp"
#include "gap_commands.hpp"

namespace {

namespace gap = darwinop::gap;

using Command = int (*)(const gap::Arguments&);

struct Row {
  CLI::App* parsed;
  Command command;
};

std::vector<Row> describe(CLI::App& app, gap::Arguments& given) {
  std::vector<Row> rows;
  const auto add = [&](const char* name, const char* what, Command command) {
    rows.push_back({app.add_subcommand(name, what), command});
    return rows.back().parsed;
  };
  const auto on_case = [&](CLI::App* one) {
    one->add_option("CASE", given.folder, "a folder with case.json and logs, see docs/gap/cases.md")->required();
    return one;
  };
  const auto json = [&](CLI::App* one) { one->add_flag("--json", given.json, "print the result as JSON"); };
  const auto out = [&](CLI::App* one, const char* what) { return one->add_option("--out", given.out, what); };

  const auto model = [&](CLI::App* one) {
    one->add_option("--model", given.model, "model file or name of an included model; default: the case's model");
    return one;
  };
  const auto report = [&](CLI::App* one, const char* otherwise) {
    one->add_option("--report", given.report, std::string{"folder for report.html; default: gap-report/"} + otherwise);
    one->add_flag("--no-report", given.no_report, "do not write a report");
    one->add_flag("--open", given.open, "open the report in a browser");
    one->add_flag("--no-open", given.no_open, "do not open it; default: opened if run in a desktop terminal");
    return one;
  };

  model(on_case(add("check", "identifiability of a case: what its logs can show", gap::check)));
  json(model(on_case(add("locate", "locate the gap: log, time, block; without a fit", gap::where))));
  CLI::App* const run = on_case(add("run", "locate, identify and evaluate on held-out logs", gap::run));
  json(report(model(run), "CASE"));
  out(run, "write the extended model, an INI file");
  CLI::App* const compare = on_case(add("report", "compare two models on the held-out logs", gap::compareModels));
  compare->add_option("--before", given.before, "model file; default: the case's model");
  compare->add_option("--after", given.after, "a model file")->required();
  json(report(compare, "CASE-compared"));
  CLI::App* const adds = model(on_case(add("add", "add effects to a model file", gap::addEffects)));
  adds->add_option("RESULTS", given.results, "report.json of run, or results.json of battery");
  adds->add_option(
      "--effect", given.effects,
      "effect to add instead of RESULTS: ID.PARAMETER=VALUE, in the unit of docs/twin/effects.md; repeatable");
  out(adds, "write the model to this file; default: print it");
  CLI::App* const makes = add("case", "make a case from recordings of experiments with one joint", gap::makeCase);
  makes->add_option("RECORDINGS", given.recordings, "recordings of darwinop experiment run, for fitting")->required();
  makes->add_option("--keep", given.kept, "held-out recording; repeatable");
  makes->add_option("--joint", given.joint, "the joint that moved")->capture_default_str();
  makes->add_option("--model", given.model, "model file or name of an included model; default: darwin-op");
  out(makes, "folder for the case")->required();
  CLI::App* const plan =
      on_case(add("plan", "find the most informative next experiment, docs/gap/plan.md", gap::planNext));
  plan->add_option("--against", given.against, "ID,ID: effects to distinguish; default: those that remain ambiguous");
  plan->add_option("--joint", given.joint, "joint that swings the arm")->capture_default_str();
  plan->add_option("--hangs-at", given.hangs_at_rad,
                   "joint angle at which the arm hangs down, rad; known for the robot's arms");
  plan->add_option("--write", given.write, "folder for the best experiments, for darwinop experiment run");
  json(plan);
  CLI::App* const exports = model(on_case(add("export", "export a case's model for another simulator", gap::writeFor)));
  exports->add_option("--to", given.target, "webots, mujoco or urdf")->required();
  out(exports, "write to this file; default: print it");

  CLI::App* const battery = add("battery", "run every case of a folder without its key", gap::runBattery);
  battery->add_option("CASES", given.folder, "a folder of cases")->required();
  out(battery, "write results.json incrementally; default: print it");
  battery->add_flag("--resume", given.resume, "continue with the existing results");
  battery->add_option("--jobs", given.jobs, "concurrent cases; default: one with all threads")
      ->check(CLI::Range(1, 1000));
  CLI::App* const hide = add("hide", "make a synthetic case with hidden effects", gap::hideEffects);
  hide->add_option("--effect", given.effects,
                   "ID, ID:SEVERITY or ID.PARAMETER=VALUE; repeatable; omit for a case without effects");
  hide->add_option("--baseline", given.baseline,
                   "V0: without dry friction, CV: with it, W: controller of Webots, F: firmware cycle of 0.1 ms")
      ->capture_default_str();
  hide->add_flag("--wrong-numbers", given.wrong_numbers, "perturb the baseline's numbers");
  hide->add_option("--seed", given.seed, "random seed")->capture_default_str();
  hide->add_option("--name", given.name, "name of the case; must not reveal its effects")->capture_default_str();
  out(hide, "folder for cases/ and key.json")->required();
  CLI::App* const make = add("make-battery", "make a suite of synthetic cases over all effects", gap::writeBattery);
  make->add_option("--part", given.part, "quick, singles, effect-free, pairs, outside or all")->capture_default_str();
  make->add_option("--seed", given.seed, "random seed")->capture_default_str();
  out(make, "folder for cases/ and key.json")->required();
  make->add_option("--cases", given.cases, "maximum number of cases");
  CLI::App* const score = add("score", "compare results with a key", gap::scoreResults);
  score->add_option("RESULTS", given.results, "results.json of battery")->required();
  score->add_option("KEY", given.key, "key.json")->required();
  json(score);
  score->add_option("--at-least", given.at_least,
                    "exit code 1 unless the fair-answer rate is at least this (upper confidence bound)");
  return rows;
}

/// Under mpirun, only the first rank does work that is not parallel.
bool isShared(Command command) {
  return command == gap::run || command == gap::runBattery;
}

int command(int count, char** arguments) {
  gap::Arguments given;
  CLI::App app{
      "Locates the difference between simulation and measurement, identifies the missing effect, adds it to the "
      "model.\n\n"
      "Exit code of run: 0 nothing is missing, 10 named, 11 ambiguous, 12 unknown, 13 cannot tell, 2 bad input.",
      "darwinop gap"};
  app.require_subcommand(1);
  app.add_option("--threads", given.threads, "number of threads; default: one per core");
  const std::vector<Row> rows = describe(app, given);
  app.footer("Example:\n  darwinop gap run tests/gap/cases/example --out repaired.ini");
  try {
    app.parse(count, arguments);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  gap::setThreads(given.threads == 0 ? gap::Ranks::cores() : given.threads);
  for (const Row& row : rows)
    if (row.parsed->parsed()) return gap::Ranks::isFirst() || isShared(row.command) ? row.command(given) : 0;
  return 2;
}

}  // namespace

int main(int count, char** arguments) {
  const gap::Ranks ranks;
  if (!gap::Ranks::isFirst())
    for (std::ostream* const out : {&std::cout, &std::cerr})
      out->setstate(std::ios::badbit);  // only the first rank prints
  try {
    const int code = command(count, arguments);
    std::cout.flush();
    return gap::Ranks::isFirst() ? code : 0;
  } catch (const std::exception& error) {
    std::cerr.clear();
    std::cerr << "darwinop gap: " << error.what() << '\n';
    return gap::Ranks::giveUp(2);
  }
}
