#include "gap_options.hpp"

#include <filesystem>

#include "connect/setting.hpp"
#include "gap/case/raw_folder.hpp"

namespace darwinop::gap {
namespace {

struct BenchmarkNames {
  const char *run, *make, *make_case, *score;
};

/// `group`: heading in --help; empty: not shown there.
void addBenchmark(CLI::App& parent, Arguments& given, std::vector<ParsedCommand>& rows, const BenchmarkNames& names,
                  const std::string& group) {
  const auto add = [&](const char* name, const char* what, Command command) {
    CLI::App* const one = parent.add_subcommand(name, what)->group(group);
    rows.push_back({one, command});
    return one;
  };
  CLI::App* const run = add(names.run, "runs every case of a folder without its answer key", runBenchmark);
  run->add_option("CASES", given.folder, "folder of cases")->required();
  run->add_option("--out", given.out, "results.json, written after each case; default: the terminal");
  run->add_flag("--resume", given.resume, "keep the results that --out has already");
  run->add_option("--jobs", given.jobs, "cases at once; default: one with all threads")->check(CLI::Range(1, 1000));
  CLI::App* const make = add(names.make, "makes many cases, over all effects", makeBenchmark);
  make->add_option("--family", given.family, "servo; body: the whole robot; thesis: findings of 2013")
      ->check(CLI::IsMember({"servo", "body", "thesis"}))
      ->capture_default_str();
  make->add_option("--effect", given.effects,
                   "body: a case for each ID, ID@pair, ID@all, or none, in place of a part; with commas: both in one");
  make->add_option("--part", given.part, "quick, singles, effect-free, pairs, outside or all")->capture_default_str();
  make->add_option("--seed", given.seed, "seed of everything random")->capture_default_str();
  make->add_option("--out", given.out, "folder for cases/ and key.json")->required();
  make->add_option("--cases", given.cases, "at most so many cases");
  CLI::App* const one = add(names.make_case, "makes one case in which effects are hidden", hideEffects);
  one->add_option("--effect", given.effects, "ID, ID:SEVERITY or ID.PARAMETER=VALUE; repeat for more; none: no effect");
  one->add_option("--baseline", given.baseline,
                  "V0 without dry friction, CV with it, W the control law of Webots, F a firmware period of 0.1 ms")
      ->capture_default_str();
  one->add_flag("--wrong-numbers", given.wrong_numbers, "the baseline's numbers are off, within their priors");
  one->add_option("--seed", given.seed, "seed of everything random")->capture_default_str();
  one->add_option("--name", given.name, "name of the case; must not reveal the effect")->capture_default_str();
  one->add_option("--out", given.out, "folder for cases/ and key.json")->required();
  CLI::App* const score = add(names.score, "compares results with an answer key", scoreBenchmark);
  score->add_option("RESULTS", given.results, "results.json of run")->required();
  score->add_option("KEY", given.key, "key.json")->required();
  score->add_flag("--json", given.json, "print the result for programs");
  score->add_flag("--table", given.table, "print what is hidden and answered in each case of a whole robot instead");
  score->add_option("--at-least", given.at_least,
                    "exit 1 unless the fair-answer rate is at least this (upper 95 % confidence bound)");
}

/// The folder of a case, also if its case.json is named.
std::string caseFolder(const std::string& named) {
  const std::filesystem::path path{named};
  if (!std::filesystem::is_regular_file(path)) return named;
  std::string folder = path.has_parent_path() ? path.parent_path().string() : ".";
  if (path.filename() == "case.json") return folder;
  const bool is_usable = std::filesystem::exists(std::filesystem::path{folder} / "case.json") || isRawFolder(folder);
  throw CLI::ValidationError{named + " is a file, but a case is a folder" +
                             (is_usable ? "; did you mean " + folder + "?" : "")};
}

}  // namespace

std::vector<ParsedCommand> addCommands(CLI::App& app, Arguments& given) {
  std::vector<ParsedCommand> rows;
  const auto add = [&](const char* name, const char* what, Command command) {
    rows.push_back({app.add_subcommand(name, what), command});
    return rows.back().parsed;
  };
  const auto on_case = [&](CLI::App* one,
                           const char* what = "a folder with case.json and logs, see docs/gap/cases.md") {
    one->add_option("CASE", given.folder, what)->required()->transform(caseFolder);
    return one;
  };
  const auto json = [&](CLI::App* one) { one->add_flag("--json", given.json, "print the result for programs"); };
  const auto out = [&](CLI::App* one, const char* what) { return one->add_option("--out", given.out, what); };

  const auto example = [](CLI::App* one, const char* command) { one->footer(std::string{"Example:\n  "} + command); };

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

  example(model(on_case(add("check", "what the logs of a case can and cannot reveal", check))),
          "darwinop gap check tests/gap/cases/example");
  CLI::App* const locate =
      model(on_case(add("locate", "where the gap is: log, time, block of the loop; without any fit", where)));
  json(locate);
  example(locate, "darwinop gap locate tests/gap/cases/example");
  CLI::App* const runs = on_case(add("run", "localize, identify, and verify on held-out logs", run),
                                 "a folder with case.json, or with BAM logs or CSVs alone");
  json(report(model(runs), "CASE"));
  out(runs, "write the model with the effects, an INI file");
  const auto raw = [&](CLI::App* one) {
    one->add_option("--declare", given.declared, "KEY=VALUE that raw logs do not contain, docs/gap/own-servo.md");
    one->add_flag("--all-logs", given.all_logs, "of a large folder of raw logs; else some are chosen");
    one->add_option("--keep", given.held_out, "a raw log that is held out from the fit; repeat for more");
  };
  raw(runs);
  example(runs,
          "darwinop gap run tests/gap/cases/example --out repaired.ini\n"
          "  darwinop gap run my-logs --declare kp=32 --declare payload_kg=0.5 --declare length_m=0.1");
  CLI::App* const compare = on_case(add("report", "compares two models on the held-out logs", compareModels));
  compare->add_option("--before", given.before, "a model file; else the case's own model");
  compare->add_option("--after", given.after, "a model file")->required();
  json(report(compare, "CASE-compared"));
  example(compare, "darwinop gap report tests/gap/cases/example --after repaired.ini");
  CLI::App* const adds = model(on_case(add("add", "adds effects to a model file", addEffects)));
  adds->add_option("RESULTS", given.results, "report.json of run, or results.json of benchmark run");
  adds->add_option("--effect", given.effects,
                   "ID.PARAMETER=VALUE instead, in the unit of docs/twin/effects.md; repeat for more");
  out(adds, "write the model to this file; default: the terminal");
  example(adds, "darwinop gap add tests/gap/cases/example gap-report/example/report.json --out repaired.ini");
  CLI::App* const makes = add("case", "recordings of experiments with one joint of the robot, as a case", makeCase);
  makes->add_option("RECORDINGS", given.recordings, "made by darwinop experiment run; to be fitted");
  makes->add_option("--from-bam", given.from_bam, "a folder with logs of BAM (JSON), in place of recordings");
  makes->add_option("--from-csv", given.from_csv, "a folder with CSVs, in place of recordings");
  makes->add_option("--to-bam", given.to_bam, "a case whose logs are written as logs of BAM");
  raw(makes);
  makes->add_option("--joint", given.joint, "the joint that moved")->default_str(kUsualJoint);
  makes->add_option("--model", given.model, "a model file or the name of a shipped model; else darwin-op");
  out(makes, "folder for the case")->required();
  example(makes,
          "darwinop gap case steps.csv release.csv --keep chirp.csv --joint ShoulderR --out shoulder\n"
          "  darwinop gap case --from-bam logs/xl330 --declare supply_V=7.4 --out xl330");
  CLI::App* const records =
      add("record", "makes the recordings of a case of the whole robot, docs/gap/body.md", recordBody);
  records->add_option("--robot", given.robot,
                      "robot; default: DARWINOP_ROBOT, or else the first one found:\n" + connect::settingChoices());
  out(records, "folder for the case")->required();
  CLI::Option* const for_all[] = {
      records->add_option("--model", given.model, "what the robot is compared with; else darwin-op"),
      records->add_flag("--floor", given.floor, "one more recording, standing on the floor"),
      records->add_flag("--resume", given.resume, "keep the recordings in the folder and make the others")};
  CLI::Option* const adds_one =
      records->add_option("--add", given.add, "one more recording for the case in --out: this experiment");
  for (CLI::Option* const other : for_all) adds_one->excludes(other);
  adds_one->needs(
      records
          ->add_option("--up", given.up, "X,Y,Z: what points up in its stand, in the trunk's frame: left, up, forward")
          ->needs(adds_one));
  records->add_flag("--yes", given.yes, "ask nothing: the robot stands ready, and moves");
  example(records,
          "darwinop gap record --robot twin --out mine\n"
          "  darwinop gap record --robot twin --add body_triangles --up 0,-1,0 --out mine\n\n"
          "Exit code: 0 done; 1 a recording failed; 2 nothing has begun; 130 stopped");
  CLI::App* const plan = on_case(add("plan", "the most informative next experiment, docs/gap/plan.md", planNext));
  plan->add_option("RESULTS", given.results, "report.json of run; else the search is repeated");
  plan->add_option("--against", given.against, "ID,ID: effects to separate; default: what the search leaves open");
  plan->add_option("--joint", given.joint, "that swings the arm")->default_str(kUsualJoint);
  plan->add_option("--hangs-at", given.hangs_at_rad, "rad: angle of the joint where the arm hangs; known for the arms");
  plan->add_option("--write", given.write, "folder for the best ones, for darwinop experiment run");
  json(plan);
  example(plan, "darwinop gap plan shoulder --write next");
  CLI::App* const exports = model(on_case(add("export", "a case's model for another simulator", writeFor)));
  example(exports, "darwinop gap export tests/gap/cases/example --to mujoco --out joint.xml");
  exports->add_option("--to", given.target, "webots, mujoco or urdf")->required();
  out(exports, "write it to this file; default: the terminal");

  CLI::App* const benchmark = app.add_subcommand("benchmark", "synthetic cases: make them, run them blind, score");
  benchmark->require_subcommand(1);
  addBenchmark(*benchmark, given, rows, {"run", "make", "make-case", "score"}, "benchmark");
  // Former names, not in --help.
  addBenchmark(app, given, rows, {"battery", "make-battery", "hide", "score"}, "");  // keep-word
  return rows;
}

}  // namespace darwinop::gap
