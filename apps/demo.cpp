// darwinop-demo: demonstrations on the physics twin without a controller: walk.
#include <CLI/CLI.hpp>
#include <string>

#include "apps/demo/walk.hpp"
#include "exit_codes.hpp"
#include "parse_arguments.hpp"
#include "run_tool.hpp"
#include "twin_look.hpp"
#include "webots/stop_signals.hpp"

namespace {

namespace twin = darwinop::twin;

int run(int argc, char** argv) {
  CLI::App app{"Demonstrations on the physics twin.", "darwinop demo"};
  twin::ShowOptions show;
  show.width = 640;
  show.height = 480;
  show.record = "walk.mp4";
  bool window = false;
  CLI::App& walk = *app.add_subcommand("walk", "stand up, walk, turn by 90 degrees and stop, in a film or a window");
  walk.description(
      "The twin stands up from its start pose, walks for 12 s, turns by 90 degrees and stops; the distance is "
      "printed. Runs in simulated time, as fast as pictures can be rendered.");
  walk.add_option("--record", show.record, "film.mp4 (uses ffmpeg), or a folder for PNG pictures; no display needed")
      ->capture_default_str();
  walk.add_flag("--view", window, "Show a window in real time instead of a film");
  walk.add_option("--seconds", show.seconds, "Duration in seconds of simulated time")->check(CLI::Range(0.1, 1e6));
  walk.add_option("--fps", show.per_second, "Pictures per second of the film")
      ->capture_default_str()
      ->check(CLI::Range(1, 120));
  describeLook(walk, show);
  walk.footer(
      "Examples:\n  darwinop demo walk\n  darwinop demo walk --view\n  darwinop demo walk --record walk.mp4 --camera "
      "side");
  app.require_subcommand(1);
  app.set_version_flag("--version", DARWINOP_VERSION);
  app.footer(
      "Example:\n  darwinop demo walk --record walk.mp4\nExit code: 0 done, 1 the robot fell, 2 wrong arguments or "
      "file, 130 Ctrl-C");
  if (const auto code = darwinop::app::parseArguments(app, argc, argv)) return *code;
  if (window) show.record.clear();
  const int status = darwinop::demo::walk(show);
  return darwinop::webots_api::stopRequested() ? darwinop::app::kStopped : status;
}

}  // namespace

int main(int argc, char** argv) {
  return darwinop::app::runTool("darwinop demo", [&] { return run(argc, argv); });
}
