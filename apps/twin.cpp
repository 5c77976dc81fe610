// darwinop-twin: view or record a run of the physics twin, render a picture, list models and effects.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <exception>
#include <iostream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "hal/text_file.hpp"
#include "parse_arguments.hpp"
#include "twin/body/robot_body.hpp"
#include "twin/effects/catalogue.hpp"
#include "twin/model/model.hpp"
#include "twin/model/shipped.hpp"
#include "twin/render/offscreen.hpp"
#include "twin/render/png.hpp"
#include "twin/view/named_poses.hpp"
#include "twin/view/show.hpp"
#include "twin_look.hpp"

namespace {

namespace twin = darwinop::twin;

struct Arguments {
  twin::ShowOptions show;
  std::string picture, pose = "start";
};

CLI::App& describeView(CLI::App& app, Arguments& a) {
  CLI::App& view = *app.add_subcommand("view", "show a run in a window, or record a film");
  view.description(
      "Starts a virtual robot with the twin's body on a pseudo terminal, in real time, and shows it. CONTROLLER drives "
      "it; without one the port is printed for 'darwinop run --robot PORT'. In the window, H shows the "
      "keys.");
  view.add_option("controller", a.show.controller, "The built program or its folder; its options after --");
  view.add_option("--record", a.show.record,
                  "Record film.mp4 (uses ffmpeg), or a folder of PNG pictures, without a window or display");
  view.add_option("--seconds", a.show.seconds, "Duration in seconds")->check(CLI::Range(0.01, 1e6));
  view.add_option("--fps", a.show.per_second, "Pictures per second of a film")
      ->capture_default_str()
      ->check(CLI::Range(1, 120));
  describeLook(view, a.show);
  view.footer(
      "Examples:\n  darwinop twin view build/release/controllers/01_hello_head\n"
      "  darwinop twin view --record hello.mp4 --seconds 10 build/release/controllers/01_hello_head");
  return view;
}

CLI::App& describePicture(CLI::App& app, Arguments& a) {
  CLI::App& picture = *app.add_subcommand("picture", "render the robot into a PNG file");
  picture.add_option("FILE", a.picture, "Output file, ending in .png")->required();
  picture.add_option("--pose", a.pose, "start (kneeling) or standing")
      ->capture_default_str()
      ->check(CLI::IsMember({"start", "standing"}));
  describeLook(picture, a.show);
  picture.footer("Example:\n  darwinop twin picture robot.png --pose standing --camera front");
  return picture;
}

/// First sentence of the model file's first comment, or the error if the file cannot be read.
std::string titleOf(const std::string& file) try {
  std::istringstream text{darwinop::readTextFile(file).value_or("")};
  std::string title;
  for (std::string line; std::getline(text, line) && line.starts_with(';');) {
    line.erase(0, line.find_first_not_of("; "));
    title += (title.empty() ? "" : " ") + line;
    if (const std::size_t end = title.find_first_of(".:"); end != std::string::npos) return title.substr(0, end);
  }
  return title;
} catch (const std::runtime_error& error) {
  return error.what();
}

int printModels() {
  const std::vector<std::string> names = twin::shippedModels();
  if (names.empty()) throw std::runtime_error(twin::listShippedModels());
  for (const std::string& name : names) {
    const std::string file = twin::findModel(name);
    std::cout << name << std::string(name.size() < 15 ? 15 - name.size() : 1, ' ') << titleOf(file) << '\n'
              << std::string(15, ' ') << file << '\n';
  }
  return 0;
}

int printEffects() {
  for (const twin::EffectInfo* effect : twin::catalogue()) {
    std::cout << effect->id << ": " << effect->title << "\n    " << effect->equation << '\n';
    for (const twin::Parameter& p : effect->parameters)
      std::cout << "    " << p.key << " = " << p.typical << (p.unit.empty() ? "" : " ") << p.unit << "  (" << p.low
                << " to " << p.high << ")  " << p.meaning << '\n';
    std::cout << "    source: " << effect->source << "\n\n";
  }
  std::cout << "Enable an effect in a model file with a section [effect NAME], or [effect NAME JOINT] for one joint.\n";
  return 0;
}

int drawPicture(const Arguments& a) {
  if (!a.picture.ends_with(".png"))
    throw std::runtime_error("invalid picture name '" + a.picture + "': must end in .png");
  twin::RobotBody body{twin::readModel(twin::findModel(a.show.model))};
  body.place(a.pose == "standing" ? twin::standingAngles() : twin::startAngles());
  twin::Offscreen offscreen{*body.mujocoModel(), a.show.width, a.show.height, twin::Quality::kStill};
  offscreen.scene().show(twin::poseOf(body));
  offscreen.scene().lookFrom(a.show.from);
  twin::writePng(a.picture, offscreen.draw());
  std::cout << "picture: " << a.picture << '\n';
  return 0;
}

int run(int argc, char** argv) {
  CLI::App app{"The physics twin of a DARwIn-OP.", "darwinop twin"};
  Arguments a;
  const CLI::App& view = describeView(app, a);
  const CLI::App& picture = describePicture(app, a);
  const CLI::App& models = *app.add_subcommand("models", "list the included models");
  app.add_subcommand("effects", "list the servo effects beyond an ideal servo");
  app.require_subcommand(1);
  app.set_version_flag("--version", DARWINOP_VERSION);
  app.footer("Example:\n  darwinop twin view build/release/controllers/01_hello_head");
  // CLI11 would give what follows to the program, not to its subcommand.
  char** const end = argv + argc;
  char** const dashes =
      argc > 1 && argv[1] == std::string_view{"view"} ? std::find(argv, end, std::string_view{"--"}) : end;
  if (const auto code = darwinop::app::parseArguments(app, static_cast<int>(dashes - argv), argv)) return *code;
  if (dashes != end) a.show.controller.insert(a.show.controller.end(), dashes + 1, end);
  if (view.parsed()) return twin::show(a.show);
  if (picture.parsed()) return drawPicture(a);
  return models.parsed() ? printModels() : printEffects();
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "darwinop twin: %s\n", error.what());
    return darwinop::app::kWrong;
  }
}
