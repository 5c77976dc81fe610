// darwinop: runs darwinop-NOUN that lies beside it, as git does it, and lists what there is.
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
    {"run", "run a controller on a robot and report how the loop fared"},
    {"runtime", "the daemon: the 16 ms loop in a process of its own; also --status, --release"},
    {"monitor", "lets onlookers see the robot: sensors, loop, faults, camera; over WebSockets, read only"},
    {"remote", "remote control over TCP: a simulator's remote-control mode drives the robot"},
    {"window", "the robot in a browser: how it stands, curves, loop, faults; without a robot, too"},
    {"experiment", "run, list and plot experiments: files that say what moves, how, and what is recorded"},
    {"motion", "look at motion pages, check, convert, play and draw them"},
    {"virtual-robot", "a CM-730 with 20 MX-28 on a pty, for work without a robot"},
    {"virtual-camera", "a camera like the robot's for one program, which needs no driver and no rights"},
    {"twin", "the physics twin: watch it, film it, list its models and effects"},
    {"demo", "the twin gets up, walks, turns and stops: a film, or a window"},
    {"gap", "find where simulation and measurement disagree, name what is missing, add it to the model"},
    {"supervisor", "parent of runtime and default controller on a robot; also --status, --stop-controller"},
    {"sound", "plays and speaks for controllers, which start it by themselves"},
    {"install", "install on a robot over ssh, send controllers; also --status, --rollback, --uninstall"},
    {"doctor", "check port, servos and real-time rights, and say how to mend what is wrong"},
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
  out << "\n'darwinop NOUN --help' tells more and shows an example. 'darwinop --version' tells the version.\n";
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
  const bool asks_help = noun == "help";
  const std::string wanted = asks_help ? arguments[2] : noun;
  const std::string program = home() / ("darwinop-" + wanted);
  std::string help = "--help", name = program;
  std::vector<char*> passed{name.data()};
  if (asks_help)
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
