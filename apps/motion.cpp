// darwinop-motion: list, show, check, convert, mirror, create, play and plot motion pages.
#include <CLI/CLI.hpp>
#include <filesystem>
#include <iostream>
#include <stdexcept>
#include <string>

#include "connect/setting.hpp"
#include "managers/motion_text/mirror.hpp"
#include "managers/motion_text/motion_file.hpp"
#include "managers/motion_text/page_section.hpp"
#include "managers/motion_text/page_text.hpp"
#include "motion_check.hpp"
#include "motion_own.hpp"
#include "motion_play.hpp"
#include "motion_plot.hpp"
#include "motion_print.hpp"
#include "parse_arguments.hpp"
#include "run_tool.hpp"

namespace {

using namespace darwinop;
using namespace darwinop::motion;

constexpr std::uint8_t kFirstTime = 125;  // 1 s, slow enough from any pose
constexpr const char* kFileHelp = "motion file, binary or text (detected); 'own': the built-in pages";

struct Arguments {
  std::string file, to_file, out, name;
  int page = 1, to = 0;
  PlayRequest play;
  PlotRequest plot;
};

CLI::App& addCommand(CLI::App& app, const char* name, const char* what, const char* example) {
  CLI::App& command = *app.add_subcommand(name, what);
  command.footer(std::string{"Example:\n  darwinop motion "} + example);
  return command;
}

CLI::Option* addPage(CLI::App& command, const char* name, int& page, const char* help) {
  return command.add_option(name, page, help)->check(CLI::Range(1, static_cast<int>(kPages) - 1));
}

std::size_t numberOf(int page) {
  return static_cast<std::size_t>(page);
}

int list(const Arguments& a) {
  std::cout << listOf(openMotions(a.file).pages);
  return 0;
}

int show(const Arguments& a) {
  const MotionFile file = openMotions(a.file);
  (void)usedPage(file.pages, a.page, a.file);
  std::cout << pictureOf(file.pages, a.page);
  return 0;
}

int convert(const Arguments& a) {
  MotionFile file = openMotions(a.file);
  const bool to_text = a.to_file.ends_with(".txt"), to_binary = a.to_file.ends_with(".bin");
  file.is_text = to_text || (!to_binary && !file.is_text);
  writeMotionFile(a.to_file, file);
  std::cout << (file.is_text ? "text: " : "binary: ") << a.to_file << '\n';
  return 0;
}

int mirror(const Arguments& a) {
  MotionFile file = openMotions(a.file);
  const int to = a.to == 0 ? a.page : a.to;
  file.pages.at(numberOf(to)) = mirrored(usedPage(file.pages, a.page, a.file));
  writeMotionFile(a.out, file);
  std::cout << "page " << to << " of " << a.out << " is page " << a.page << ", left and right swapped\n";
  return 0;
}

int begin(const Arguments& a) {
  if (std::filesystem::exists(a.out)) throw std::runtime_error(a.out + ": already exists; choose another name");
  PageSection section{numberOf(a.page)};
  section.set("name", '"' + a.name + '"');
  Page page = section.finish();
  page.steps = 1;
  page.step.front().time = kFirstTime;
  for (const JointRow& joint : kJointTable) page.step.front().position.at(joint.id) = joint.start;
  const std::string remarks =
      "# One row a joint, in degrees; one column a step, up to seven. Times in seconds.\n"
      "# 'keep' leaves a joint where it is. Fields: docs/motion-command.md.\n";
  writeText(a.out, std::string{kTextTitle} + "\n\n" + remarks + writePage(page, numberOf(a.page)));
  std::cout << "created page " << a.page << " in " << a.out << ", one step: the start pose\n";
  return 0;
}

void describePlay(CLI::App& command, PlayRequest& play) {
  command.add_option("FILE", play.file, "motion file, binary or text, a .motion file, or 'own'")->required();
  command.add_option("PAGE", play.pages, "pages to play in this order; omit for a .motion file")
      ->check(CLI::Range(1, static_cast<int>(kPages) - 1));
  command.add_option("--robot", play.robot,
                     "robot; default: DARWINOP_ROBOT, or else the twin:\n" + darwinop::connect::settingChoices());
  command.add_option("--record", play.record, "write every cycle to this CSV file, see docs/logs.md");
  command.add_option("--period", play.period_ms, "period of the loop in ms, 16 or 8")->check(CLI::Range(1, 1000));
  command.add_flag("--yes", play.yes, "move a real robot without asking");
}

void describePlot(CLI::App& command, PlotRequest& plot) {
  command.add_option("FILE", plot.file, kFileHelp)->required();
  addPage(command, "PAGE", plot.page, "page number")->required();
  command.add_option("--out", plot.out, "picture.png, or an interactive page.html")->required();
  command.add_option("--from", plot.from, "initial pose: first (the page's own first pose) or start")
      ->check(CLI::IsMember({"first", "start"}))
      ->capture_default_str();
}

using Action = int (*)(const Arguments&);

void describe(CLI::App& app, Arguments& a, Action& action) {
  const auto command = [&](const char* name, Action does, const char* what, const char* example) -> CLI::App& {
    CLI::App& added = addCommand(app, name, what, example);
    added.callback([&action, does] { action = does; });
    return added;
  };
  const auto with_file = [&a](CLI::App& added) -> CLI::App& {
    added.add_option("FILE", a.file, kFileHelp)->required();
    return added;
  };
  with_file(command("list", list, "list the playable pages", "list motion_4096.bin"));
  CLI::App& shown =
      with_file(command("show", show, "show angles, times and gains of a page", "show motion_4096.bin 12"));
  addPage(shown, "PAGE", a.page, "page number")->required();
  with_file(command(
      "check", [](const Arguments& all) { return checkMotions(all.file); },
      "check pages for problems on a robot; exit code 1 if there are findings", "check motion_4096.bin"));
  CLI::App& converted =
      command("convert", convert, "convert between binary and text files", "convert motion_4096.bin motion.txt");
  converted.add_option("FROM", a.file, kFileHelp)->required();
  converted
      .add_option("TO", a.to_file, "NAME.txt: text, NAME.bin: binary, else the other kind; overwritten if it exists")
      ->required();
  CLI::App& swapped = with_file(
      command("mirror", mirror, "swap left and right of a page", "mirror motion.txt 12 --to 13 --out both_kicks.txt"));
  addPage(swapped, "PAGE", a.page, "page number")->required();
  addPage(swapped, "--to", a.to, "target page of the mirrored one (default: PAGE itself)");
  swapped.add_option("--out", a.out, "output file, of the same kind as FILE")->required();
  describePlay(command(
                   "play", [](const Arguments& all) { return play(all.play); },
                   "play pages or a .motion file on the twin or a robot, and report loads and errors", "play own 9"),
               a.play);
  describePlot(command(
                   "plot", [](const Arguments& all) { return plotPage(all.plot); },
                   "plot the goals of a page over time", "plot own 9 --out page.png"),
               a.plot);
  CLI::App& begun =
      command("new", begin, "create a text file with one page: the start pose", "new --name bow --out bow.txt");
  begun.add_option("--name", a.name, "page name, up to 13 characters")->required();
  begun.add_option("--out", a.out, "new text file")->required();
  addPage(begun, "--page", a.page, "page number")->capture_default_str();
}

int run(int argc, char** argv) {
  CLI::App app{"Tools for motion pages: sequences of robot poses.", "darwinop motion"};
  Arguments a;
  Action action = nullptr;
  describe(app, a, action);
  app.require_subcommand(1);
  app.set_version_flag("--version", DARWINOP_VERSION);
  app.footer(
      "Example:\n  darwinop motion list own\nExit code: 0 done; 1 'check' has findings, the robot ended 'play', or its "
      "recording is incomplete; 2 wrong arguments, file or robot: nothing moved; 3 'play' needs --yes; 130 Ctrl-C");
  if (const auto code = darwinop::app::parseArguments(app, argc, argv)) return *code;
  return action(a);
}

}  // namespace

int main(int argc, char** argv) {
  return darwinop::app::runTool("darwinop motion", [&] { return run(argc, argv); });
}
