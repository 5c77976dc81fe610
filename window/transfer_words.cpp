#include "window/transfer_words.hpp"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "window/installer_step.hpp"

namespace darwinop::window {
namespace {

using Words = nlohmann::json;

constexpr std::array<std::string_view, 10> kActionNames{"status",     "install", "send", "run",      "make-default",
                                                        "no-default", "stop",    "logs", "rollback", "uninstall"};
constexpr std::size_t kLongestName = 253, kLongestPath = 1000, kLongestArgument = 200, kMostArguments = 20;

bool isOrdinary(char letter) {
  return static_cast<unsigned char>(letter) >= ' ' && letter != '\x7f';
}

/// A name for ssh: of these letters, and no option.
bool isName(std::string_view text, std::string_view more) {
  const auto may = [more](char letter) {
    return (letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z') || (letter >= '0' && letter <= '9') ||
           more.find(letter) != std::string_view::npos;
  };
  return !text.empty() && text.size() <= kLongestName && text[0] != '-' && std::ranges::all_of(text, may);
}

const std::string* textOf(const Words& said) {
  return said.get_ptr<const std::string*>();
}

std::string takeArguments(const Words& said, std::vector<std::string>& arguments) {
  std::string trouble = "\"arguments\" has to be a list of at most 20 texts of at most 200 bytes";
  if (!said.is_array() || said.size() > kMostArguments) return trouble;
  for (const Words& word : said) {
    const std::string* const text = textOf(word);
    if (text == nullptr || text->size() > kLongestArgument || !std::ranges::all_of(*text, isOrdinary)) return trouble;
    arguments.push_back(*text);
  }
  return {};
}

std::string takeAction(const Words& said, TransferAction& action) {
  const std::string* const text = textOf(said);
  const auto found = text == nullptr ? kActionNames.end() : std::ranges::find(kActionNames, *text);
  if (found == kActionNames.end())
    return "\"action\" is one of status, install, send, run, make-default, no-default, stop, logs, rollback, uninstall";
  action = static_cast<TransferAction>(found - kActionNames.begin());
  return {};
}

std::string takeHostKey(const Words& said, std::string& key) {
  const std::string* const text = textOf(said);
  if (text == nullptr || !isFingerprint(*text)) return "\"host_key\" has to be a fingerprint, SHA256 and 43 letters";
  key = *text;
  return {};
}

std::string takeFlag(const Words& said, const char* what, bool& flag) {
  if (!said.is_boolean()) return std::string{"\""} + what + "\" has to be true or false";
  flag = said.get<bool>();
  return {};
}

std::string takeStart(const Words& said, TransferStart& start) {
  if (!said.is_object()) return "\"start\" has to be an object with an \"action\" and a \"robot\"";
  bool has_action = false, has_robot = false;
  for (const auto& [name, value] : said.items()) {
    std::string why;
    if (name == "action") {
      has_action = true;
      why = takeAction(value, start.action);
    } else if (name == "robot") {
      has_robot = true;
      why = takeRobot(value, start.robot);
    } else if (name == "controller") {
      why = takePath(value, "controller", start.controller);
    } else if (name == "arguments") {
      why = takeArguments(value, start.arguments);
    } else if (name == "force") {
      why = takeFlag(value, "force", start.force);
    } else if (name == "host_key") {
      why = takeHostKey(value, start.host_key);
    } else {
      why = "\"start\" knows action, robot, controller, arguments, force and host_key";
    }
    if (!why.empty()) return why;
  }
  if (!has_action || !has_robot) return "\"start\" needs an \"action\" and a \"robot\"";
  if (start.controller.empty() == hasController(start.action))
    return hasController(start.action) ? "choose the folder of a controller"
                                       : "\"controller\" does not go with this action";
  if (!start.arguments.empty() && start.action != TransferAction::kRun) return "\"arguments\" go with \"run\"";
  return {};
}

}  // namespace

std::string_view nameOf(TransferAction action) {
  return kActionNames.at(static_cast<std::size_t>(action));
}

bool hasController(TransferAction action) {
  return action == TransferAction::kSend || action == TransferAction::kRun || action == TransferAction::kMakeDefault;
}

std::string takePath(const Words& said, std::string_view what, std::string& path) {
  const std::string* const text = textOf(said);
  if (text == nullptr || text->size() > kLongestPath || !std::ranges::all_of(*text, isOrdinary))
    return "\"" + std::string{what} + "\" has to be a path of at most 1000 bytes";
  path = *text;
  return {};
}

std::string takeRobot(const Words& said, RobotAddress& robot) {
  if (!said.is_object()) return R"("robot" has to be an object: {"address": "192.168.123.1", "user": "darwin"})";
  for (const auto& [name, value] : said.items()) {
    const std::string* const text = textOf(value);
    if (name == "address") {
      if (text == nullptr || !isName(*text, ".:%-_"))
        return "the address has to be a name or a number such as 192.168.123.1";
      robot.address = *text;
    } else if (name == "user") {
      if (text == nullptr || !isName(*text, "._-"))
        return "the user has to be a name of letters and digits such as darwin";
      robot.user = *text;
    } else if (name == "key") {
      if (std::string why = takePath(value, "key", robot.key); !why.empty()) return why;
    } else if (name == "port") {
      if (!value.is_number_integer() || value.get<std::int64_t>() < 0 || value.get<std::int64_t>() > 65535)
        return "the port has to be a number from 1 to 65535; 0: the usual one";
      robot.port = value.get<std::uint16_t>();
    } else {
      return "\"robot\" knows address, user, key and port";
    }
  }
  return robot.address.empty() || robot.user.empty() ? "a robot has an address and a user" : "";
}

Words jsonOf(const RobotAddress& robot) {
  return {{"address", robot.address}, {"user", robot.user}, {"key", robot.key}, {"port", robot.port}};
}

std::optional<TransferWords> readTransfer(std::string_view text, std::string& why) {
  const Words said = Words::parse(text.begin(), text.end(), nullptr, false);
  why = "that is no JSON object with one of start, cancel, more and forget";
  if (!said.is_object() || said.size() != 1) return std::nullopt;
  TransferWords words;
  const std::string& name = said.items().begin().key();
  const Words& value = said.front();
  if (name == "start") {
    why = takeStart(value, words.start.emplace());
  } else if (name == "forget") {
    why = takeRobot(value, words.forget.emplace());
  } else if (name == "cancel") {
    why = takeFlag(value, "cancel", words.cancel);
  } else if (name == "more") {
    why = value.is_number_unsigned() ? "" : "\"more\" has to be the number of a line";
    if (why.empty()) words.more = value.get<std::uint64_t>();
  }
  if (!why.empty()) return std::nullopt;
  return words;
}

}  // namespace darwinop::window
