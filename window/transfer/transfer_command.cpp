// Command lines of darwinop-install.
#include "window/transfer/transfer_command.hpp"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string_view>

#include "core/text/shell_word.hpp"

namespace darwinop::window {
namespace {

namespace fs = std::filesystem;

fs::path absolutePath(const std::string& text) {
  const char* const home = std::getenv("HOME");
  if (home != nullptr && (text == "~" || text.starts_with("~/"))) return fs::path{home + text.substr(1)};
  return fs::absolute(text);
}

std::string controllerFolder(const std::string& text) {
  std::error_code unknown;
  const fs::path folder = absolutePath(text);
  if (!fs::is_directory(folder, unknown))
    throw std::runtime_error("there is no folder " + folder.string() +
                             "; give the folder with the controller's sources");
  return folder.string();
}

std::string keyFile(const std::string& text) {
  const fs::path key = absolutePath(text);
  if (access(key.c_str(), R_OK) != 0)
    throw std::runtime_error("cannot read key " + key.string() + ": " + std::strerror(errno));
  return key.string();
}

std::vector<std::string> actionArguments(const TransferStart& start) {
  switch (start.action) {
    case TransferAction::kInstall:
      return {};
    case TransferAction::kLogs:
      return {"--logs", "-f"};
    case TransferAction::kSend:
      return {"--controller", controllerFolder(start.controller)};
    case TransferAction::kRun:
    case TransferAction::kMakeDefault:
      return {"--controller", controllerFolder(start.controller), "--" + std::string{nameOf(start.action)}};
    default:
      return {"--" + std::string{nameOf(start.action)}};
  }
}

bool holdsController(const fs::path& folder) {
  std::error_code unknown;
  for (const auto& entry : fs::directory_iterator{folder, unknown})
    if (entry.path().extension() == ".cpp" || entry.path().filename() == "Makefile.darwin-op") return true;
  return false;
}

}  // namespace

std::vector<std::string> installerArguments(const TransferStart& start) {
  std::vector<std::string> arguments = actionArguments(start);
  const auto add = [&arguments](std::initializer_list<std::string> more) { arguments.insert(arguments.end(), more); };
  if (start.force) add({"--force"});
  if (!start.host_key.empty()) add({"--host-key", start.host_key});
  if (start.robot.port != 0) add({"-p", std::to_string(start.robot.port)});
  if (!start.robot.key.empty()) add({"-i", keyFile(start.robot.key)});
  add({start.robot.user + "@" + start.robot.address});
  if (start.arguments.empty()) return arguments;
  add({"--"});
  arguments.insert(arguments.end(), start.arguments.begin(), start.arguments.end());
  return arguments;
}

std::string typedCommand(const std::vector<std::string>& arguments) {
  std::string text = "darwinop install";
  for (const std::string& word : arguments) text += " " + text::shellWord(word);
  return text;
}

std::optional<RobotAddress> robotOf(const std::string& target, const std::string& port, const std::string& key) {
  const std::size_t at = target.rfind('@');
  if (at == std::string::npos) return std::nullopt;
  nlohmann::json parsed{{"user", target.substr(0, at)}, {"address", target.substr(at + 1)}};
  if (!port.empty()) parsed["port"] = nlohmann::json::parse(port, nullptr, false);
  if (!key.empty()) parsed["key"] = absolutePath(key).string();
  RobotAddress robot;
  return takeRobot(parsed, robot).empty() ? std::optional{robot} : std::nullopt;
}

std::vector<std::string> controllersBeside(const std::string& installer) {
  std::error_code unknown;
  const fs::path tree = fs::canonical(installer, unknown).parent_path().parent_path();
  std::vector<std::string> folders;
  if (unknown) return folders;
  for (const auto& entry : fs::directory_iterator{tree / "controllers", unknown})
    if (entry.is_directory(unknown) && holdsController(entry.path())) folders.push_back(entry.path().string());
  std::ranges::sort(folders);
  return folders;
}

}  // namespace darwinop::window
