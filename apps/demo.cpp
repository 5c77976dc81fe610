// darwinop-demo: what the robot can do, on the physics twin, without a controller to build: walk.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <string>

#include "apps/demo/walk.hpp"
#include "twin_look.hpp"

namespace {

namespace twin = darwinop::twin;

constexpr int kWrong = 2;  // exit status: a mistake in the arguments, or what makes them impossible

int run(int argc, char** argv) {
  CLI::App app{"What the robot can do, shown on the physics twin.", "darwinop demo"};
  twin::ShowOptions show;
  show.width = 640;
  show.height = 480;
  show.record = "walk.mp4";
  bool window = false;
  CLI::App& walk = *app.add_subcommand("walk", "gets up, walks, turns a quarter round, stops: a film, or a window");
  walk.description(
      "The twin gets up from its start pose, walks for 12 s, turns by 90 degrees and stops, and how far it got is "
      "printed. In simulated time: the film is made as fast as pictures can be drawn.");
  walk.add_option("--record", show.record, "The film.mp4 (by ffmpeg), or a folder for PNG pictures; needs no display")
      ->capture_default_str();
  walk.add_flag("--view", window, "A window instead of a film, in real time");
  walk.add_option("--seconds", show.seconds, "End after so many seconds of the robot's clock")
      ->check(CLI::Range(0.1, 1e6));
  walk.add_option("--fps", show.per_second, "Pictures a second of the film")
      ->capture_default_str()
      ->check(CLI::Range(1, 120));
  describeLook(walk, show);
  walk.footer(
      "Examples:\n  darwinop demo walk\n  darwinop demo walk --view\n  darwinop demo walk --record walk.mp4 --camera "
      "side");
  app.require_subcommand(1);
  app.set_version_flag("--version", DARWINOP_VERSION);
  app.footer("Example:\n  darwinop demo walk --record walk.mp4");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& mistake) {
    return app.exit(mistake) == 0 ? 0 : kWrong;
  }
  if (window) show.record.clear();
  return darwinop::demo::walk(show);
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "darwinop demo: %s\n", error.what());
    return kWrong;
  }
}
