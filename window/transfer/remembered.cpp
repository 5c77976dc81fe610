// Reads and writes the file of recently used robots and controllers.
#include "window/transfer/remembered.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <utility>

#include "core/json/json_text.hpp"
#include "hal/text_file.hpp"

namespace darwinop::window {
namespace {

using nlohmann::json;
namespace fs = std::filesystem;

constexpr std::size_t kLargestFile = std::size_t{256} * 1024;

/// Parses the file; returns an error text or an empty string.
std::string takeAll(const std::string& text, Remembered& all) {
  const json parsed = json::parse(text, nullptr, false);
  if (!parsed.is_object()) return "not a JSON object";
  for (const auto& [name, list] : parsed.items()) {
    if (name != "robots" && name != "controllers") return "unknown member \"" + name + "\"; use robots and controllers";
    if (!list.is_array() || list.size() > RememberedFile::kMost)
      return "\"" + name + "\" must be a list of at most " + std::to_string(RememberedFile::kMost);
    for (const json& entry : list) {
      std::string why = name == "robots" ? takeRobot(entry, all.robots.emplace_back())
                                         : takePath(entry, "controllers", all.controllers.emplace_back());
      if (!why.empty()) return why;
    }
  }
  return {};
}

template <class Entry, class Same>
void toFront(std::vector<Entry>& list, const Entry& entry, Same same) {
  std::erase_if(list, same);
  list.insert(list.begin(), entry);
  if (list.size() > RememberedFile::kMost) list.resize(RememberedFile::kMost);
}

/// No fsync: it would block the web server's thread and thus a driving page. The rename leaves the old or the new file.
bool writeWhole(int file, std::string_view text) {
  while (!text.empty()) {
    const ssize_t count = ::write(file, text.data(), text.size());
    if (count < 0 && errno != EINTR) return false;
    if (count > 0) text.remove_prefix(static_cast<std::size_t>(count));
  }
  return true;
}

}  // namespace

fs::path RememberedFile::usual() {
  const char* const config = std::getenv("XDG_CONFIG_HOME");
  if (config != nullptr && config[0] == '/') return fs::path{config} / "darwinop" / "robots.json";
  const char* const home = std::getenv("HOME");
  return home == nullptr || home[0] != '/' ? fs::path{} : fs::path{home} / ".config" / "darwinop" / "robots.json";
}

RememberedFile::RememberedFile(fs::path file) : file_{std::move(file)} {
  read();
}

void RememberedFile::note(const RobotAddress& robot, const std::string& controller) {
  read();
  toFront(all_.robots, robot,
          [&](const RobotAddress& other) { return other.address == robot.address && other.user == robot.user; });
  if (!controller.empty())
    toFront(all_.controllers, controller, [&](const std::string& other) { return other == controller; });
  write();
}

void RememberedFile::forget(const RobotAddress& robot) {
  read();
  std::erase_if(all_.robots,
                [&](const RobotAddress& other) { return other.address == robot.address && other.user == robot.user; });
  write();
}

void RememberedFile::read() try {
  error_.clear();
  std::error_code unknown;
  if (file_.empty() || !fs::exists(file_, unknown)) return;
  Remembered found;
  const std::string why = takeAll(readTextFile(file_, kLargestFile).value_or(""), found);
  if (!why.empty()) return moveAside(why);
  all_ = std::move(found);
} catch (const std::runtime_error& error) {
  moveAside(error.what());
}

/// Keeps an invalid file so that the user can repair it.
void RememberedFile::moveAside(const std::string& why) {
  std::error_code failed;
  const fs::path aside = file_.string() + ".damaged";
  fs::rename(file_, aside, failed);
  error_ =
      file_.string() + " is invalid (" + why + "). A new list of robots is started" +
      (failed ? ", but the file cannot be renamed: " + failed.message() : "; the file is kept as " + aside.string());
}

void RememberedFile::write() {
  if (file_.empty()) return;
  json robots = json::array();
  for (const RobotAddress& robot : all_.robots) robots.push_back(jsonOf(robot));
  const std::string text = jsonText(json{{"robots", robots}, {"controllers", all_.controllers}}, 2) + "\n";
  std::error_code failed;
  fs::create_directories(file_.parent_path(), failed);
  const std::string next = file_.string() + ".new-" + std::to_string(getpid());
  const int out = open(next.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_NOFOLLOW | O_CLOEXEC, S_IRUSR | S_IWUSR);
  const bool well = out >= 0 && writeWhole(out, text) && rename(next.c_str(), file_.c_str()) == 0;
  if (!well) error_ = "robots are not remembered: cannot write " + file_.string() + ": " + std::strerror(errno);
  if (!well && out >= 0) unlink(next.c_str());
  if (out >= 0) close(out);
}

}  // namespace darwinop::window
