// darwinop-gap: where do simulation and measurement disagree, and what is missing from the model?
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
  const auto json = [&](CLI::App* one) { one->add_flag("--json", given.json, "print the result for programs"); };
  const auto out = [&](CLI::App* one, const char* what) { return one->add_option("--out", given.out, what); };

  const auto model = [&](CLI::App* one) {
    one->add_option("--model", given.model, "a model file or the name of a shipped model, in place of the case's own");
    return one;
  };
  const auto report = [&](CLI::App* one, const char* otherwise) {
    one->add_option("--report", given.report, std::string{"folder for report.html; else gap-report/"} + otherwise);
    one->add_flag("--no-report", given.no_report, "write no report");
    one->add_flag("--open", given.open, "show the report in a browser, wherever this runs");
    one->add_flag("--no-open", given.no_open, "never; else on a terminal of a desktop");
    return one;
  };

  model(on_case(add("check", "what the logs of a case can and cannot reveal", gap::check)));
  json(model(on_case(add("locate", "where the gap is: log, time, part of the loop; fits nothing", gap::where))));
  CLI::App* const run = on_case(add("run", "all of it: where, what, and how much it helps on kept logs", gap::run));
  json(report(model(run), "CASE"));
  out(run, "write the model with what was found, an INI file");
  CLI::App* const compare = on_case(add("report", "two models on the kept logs, before and after", gap::compareModels));
  compare->add_option("--before", given.before, "a model file; else the case's own model");
  compare->add_option("--after", given.after, "a model file")->required();
  json(report(compare, "CASE-compared"));
  CLI::App* const adds = model(on_case(add("add", "puts effects into a model file", gap::addEffects)));
  adds->add_option("RESULTS", given.results, "report.json of run, or results.json of battery");
  adds->add_option("--effect", given.effects,
                   "ID.PARAMETER=VALUE instead, in the unit of docs/twin/effects.md; again for more");
  out(adds, "write the model there, not to the terminal");
  CLI::App* const makes =
      add("case", "recordings of experiments with one joint of the robot, as a case", gap::makeCase);
  makes->add_option("RECORDINGS", given.recordings, "made by darwinop experiment run; to be fitted")->required();
  makes->add_option("--keep", given.kept, "a recording that is kept for judging; again for more");
  makes->add_option("--joint", given.joint, "the joint that moved")->capture_default_str();
  makes->add_option("--model", given.model, "a model file or the name of a shipped model; else darwin-op");
  out(makes, "folder for the case")->required();
  CLI::App* const plan = on_case(add("plan", "the experiment that would tell most, docs/gap/plan.md", gap::planNext));
  plan->add_option("--against", given.against, "ID,ID: effects to tell apart; else what a naming leaves open");
  plan->add_option("--joint", given.joint, "that swings the arm")->capture_default_str();
  plan->add_option("--hangs-at", given.hangs_at_rad, "rad: angle of the joint where the arm hangs; known for the arms");
  plan->add_option("--write", given.write, "folder for the best ones, for darwinop experiment run");
  json(plan);
  CLI::App* const exports = model(on_case(add("export", "a case's model for another simulator", gap::writeFor)));
  exports->add_option("--to", given.target, "webots, mujoco or urdf")->required();
  out(exports, "write it there, not to the terminal");

  CLI::App* const battery = add("battery", "every case of a folder, blind", gap::runBattery);
  battery->add_option("CASES", given.folder, "a folder of cases")->required();
  out(battery, "write results.json there, case by case, not to the terminal");
  battery->add_flag("--resume", given.resume, "go on with the results that are there");
  battery->add_option("--jobs", given.jobs, "cases at once; else one with all threads")->check(CLI::Range(1, 1000));
  CLI::App* const hide = add("hide", "make a case in which effects are hidden", gap::hideEffects);
  hide->add_option("--effect", given.effects,
                   "ID, ID:SEVERITY or ID.PARAMETER=VALUE; again for more; none: nothing is");
  hide->add_option("--baseline", given.baseline,
                   "V0 without dry friction, CV with, W the law of Webots, F a firmware of 0.1 ms")
      ->capture_default_str();
  hide->add_flag("--wrong-numbers", given.wrong_numbers, "the baseline's numbers are a little off");
  hide->add_option("--seed", given.seed, "of all that is drawn")->capture_default_str();
  hide->add_option("--name", given.name, "of the case; must not tell what is in it")->capture_default_str();
  out(hide, "folder for cases/ and key.json")->required();
  CLI::App* const make = add("make-battery", "many such cases, over all effects", gap::writeBattery);
  make->add_option("--part", given.part, "quick, singles, effect-free, pairs, outside or all")->capture_default_str();
  make->add_option("--seed", given.seed, "of all that is drawn")->capture_default_str();
  out(make, "folder for cases/ and key.json")->required();
  make->add_option("--cases", given.cases, "at most so many of them");
  CLI::App* const score = add("score", "compares results with a key", gap::scoreResults);
  score->add_option("RESULTS", given.results, "results.json of battery")->required();
  score->add_option("KEY", given.key, "key.json")->required();
  json(score);
  score->add_option("--at-least", given.at_least,
                    "exit code 1 when so large a share of cases that lead nobody astray is out of the question");
  return rows;
}

/// Under mpirun, what one rank does alone is for the first.
bool isShared(Command command) {
  return command == gap::run || command == gap::runBattery;
}

int command(int count, char** arguments) {
  gap::Arguments given;
  CLI::App app{
      "Finds where simulation and measurement disagree, names the missing effect, adds it to the model.\n\n"
      "Exit code of run: 0 nothing is missing, 10 named, 11 ambiguous, 12 unknown, 13 cannot tell, 2 bad input.",
      "darwinop gap"};
  app.require_subcommand(1);
  app.add_option("--threads", given.threads, "threads to use; else one a core");
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
    for (std::ostream* const out : {&std::cout, &std::cerr}) out->setstate(std::ios::badbit);  // one tells for all
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
