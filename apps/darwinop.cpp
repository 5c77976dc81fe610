// darwinop: runs darwinop-NOUN from its own folder, and lists the available commands.
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <iostream>
#include <set>
#include <string>
#include <vector>

namespace fs = std::filesystem;

namespace {

struct Noun {
  std::string_view name, what;
};

constexpr Noun kNouns[] = {
    {"run", "run a controller on a robot and report loop statistics"},
    {"runtime", "the daemon: runs the 16 ms loop; also --status, --release"},
    {"monitor", "publish sensors, loop, faults and camera over WebSockets, read-only"},
    {"remote", "remote control over TCP, for a simulator's remote-control mode"},
    {"window", "show a real or simulated robot in a browser: pose, curves, loop, faults"},
    {"experiment", "run, list and plot experiments"},
    {"motion", "list, check, convert, play and plot motion pages"},
    {"virtual-robot", "simulate a CM-730 with 20 MX-28 on a pty"},
    {"virtual-camera", "simulate the robot's camera for one program, without a driver"},
    {"twin", "the physics twin: view, film, picture, list models and effects"},
    {"demo", "the twin stands up, walks, turns and stops, in a film or a window"},
    {"gap", "compare model and logs, identify missing effects, extend the model"},
    {"supervisor", "parent of runtime and default controller on a robot; also --status, --stop-controller"},
    {"sound", "sound and speech for controllers, which start it automatically"},
    {"install", "install on a robot over ssh, send controllers; also --status, --rollback, --uninstall"},
    {"calibrate", "measure the inertial sensor and zero offsets, keep them in robot.ini"},
    {"doctor", "check port, servos and real-time permissions, with a fix for each finding"},
};

fs::path home() {
  std::error_code unknown;
  return fs::read_symlink("/proc/self/exe", unknown).parent_path();
}

std::set<std::string> installed() {
  std::set<std::string> nouns;
  std::error_code unreadable;
  for (const auto& entry : fs::directory_iterator{home(), unreadable}) {
    const std::string name = entry.path().filename();
    if (name.starts_with("darwinop-") && access(entry.path().c_str(), X_OK) == 0) nouns.insert(name.substr(9));
  }
  return nouns;
}

void printHelp(std::ostream& out) {
  out << "usage: darwinop NOUN [arguments]\n\n";
  std::set<std::string> nouns = installed();
  for (const Noun& noun : kNouns)
    if (nouns.erase(std::string{noun.name}) != 0)
      out << "  " << noun.name << std::string(15 - noun.name.size(), ' ') << noun.what << '\n';
  for (const std::string& other : nouns) out << "  " << other << '\n';
  out << "\n'darwinop NOUN --help' shows options and an example. 'darwinop --version' prints the version.\n";
}

}  // namespace

int main(int count, char** arguments) {
  const std::string noun = count > 1 ? arguments[1] : "--help";
  if (noun == "--version") {
    std::cout << "darwinop " << DARWINOP_VERSION << '\n';
    return 0;
  }
  if (noun == "--help" || noun == "-h" || (noun == "help" && count == 2)) {
    printHelp(std::cout);
    return count > 1 ? 0 : 2;
  }
  const bool is_help = noun == "help";
  const std::string wanted = is_help ? arguments[2] : noun;
  const std::string program = home() / ("darwinop-" + wanted);
  std::string help = "--help", name = program;
  std::vector<char*> passed{name.data()};
  if (is_help)
    passed.push_back(help.data());
  else
    passed.insert(passed.end(), arguments + 2, arguments + count);
  passed.push_back(nullptr);
  if (!wanted.starts_with('-') && wanted.find('/') == std::string::npos) execv(program.c_str(), passed.data());
  std::cerr << "darwinop: no command '" << wanted << "' ("
            << (access(program.c_str(), F_OK) == 0 ? std::strerror(errno) : program + " does not exist") << ")\n\n";
  printHelp(std::cerr);
  return 2;
}
