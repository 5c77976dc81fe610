// Parser of requests on the transfer channel.
#include "window/transfer/transfer_message.hpp"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "window/messages.hpp"
#include "window/transfer/installer_step.hpp"

namespace darwinop::window {
namespace {

using Json = nlohmann::json;

constexpr std::array<std::string_view, 10> kActionNames{"status",     "install", "send", "run",      "make-default",
                                                        "no-default", "stop",    "logs", "rollback", "uninstall"};
constexpr std::size_t kMaxName = 253, kMaxPath = 1000, kMaxArgument = 200, kMaxArguments = 20;

bool isOrdinary(char letter) {
  return static_cast<unsigned char>(letter) >= ' ' && letter != '\x7f';
}

/// A host or user name for ssh: allowed characters only, not an option.
bool isName(std::string_view text, std::string_view more) {
  const auto may = [more](char letter) {
    return (letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z') || (letter >= '0' && letter <= '9') ||
           more.find(letter) != std::string_view::npos;
  };
  return !text.empty() && text.size() <= kMaxName && text[0] != '-' && std::ranges::all_of(text, may);
}

const std::string* textOf(const Json& value) {
  return value.get_ptr<const std::string*>();
}

std::string takeArguments(const Json& value, std::vector<std::string>& arguments) {
  const std::string error = "\"arguments\" must be a list of at most 20 strings of at most 200 bytes";
  if (!value.is_array() || value.size() > kMaxArguments) return error;
  for (const Json& word : value) {
    const std::string* const text = textOf(word);
    if (text == nullptr || text->size() > kMaxArgument || !std::ranges::all_of(*text, isOrdinary)) return error;
    arguments.push_back(*text);
  }
  return {};
}

std::string takeAction(const Json& value, TransferAction& action) {
  const std::string* const text = textOf(value);
  const auto found = text == nullptr ? kActionNames.end() : std::ranges::find(kActionNames, *text);
  if (found == kActionNames.end())
    return "\"action\" must be one of status, install, send, run, make-default, no-default, stop, logs, rollback, "
           "uninstall";
  action = static_cast<TransferAction>(found - kActionNames.begin());
  return {};
}

std::string takeHostKey(const Json& value, std::string& key) {
  const std::string* const text = textOf(value);
  if (text == nullptr || !isFingerprint(*text)) return "\"host_key\" must be a fingerprint: SHA256: and 43 characters";
  key = *text;
  return {};
}

std::string takeFlag(const Json& value, const char* what, bool& flag) {
  if (!value.is_boolean()) return std::string{"\""} + what + "\" must be true or false";
  flag = value.get<bool>();
  return {};
}

std::string takeStart(const Json& object, TransferStart& start) {
  if (!object.is_object()) return "\"start\" must be an object with an \"action\" and a \"robot\"";
  bool has_action = false, has_robot = false;
  for (const auto& [name, value] : object.items()) {
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
      why = "unknown member of \"start\"; use action, robot, controller, arguments, force and host_key";
    }
    if (!why.empty()) return why;
  }
  if (!has_action || !has_robot) return "\"start\" requires an \"action\" and a \"robot\"";
  if (start.controller.empty() == hasController(start.action))
    return hasController(start.action) ? messages::kNoControllerFolder
                                       : "\"controller\" is not allowed with this action";
  if (!start.arguments.empty() && start.action != TransferAction::kRun)
    return "\"arguments\" are allowed only with \"run\"";
  return {};
}

}  // namespace

std::string_view nameOf(TransferAction action) {
  return kActionNames.at(static_cast<std::size_t>(action));
}

bool hasController(TransferAction action) {
  return action == TransferAction::kSend || action == TransferAction::kRun || action == TransferAction::kMakeDefault;
}

std::string takePath(const Json& value, std::string_view what, std::string& path) {
  const std::string* const text = textOf(value);
  if (text == nullptr || text->size() > kMaxPath || !std::ranges::all_of(*text, isOrdinary))
    return "\"" + std::string{what} + "\" must be a path of at most 1000 bytes";
  path = *text;
  return {};
}

std::string takeRobot(const Json& object, RobotAddress& robot) {
  if (!object.is_object()) return R"("robot" must be an object: {"address": "192.168.123.1", "user": "darwin"})";
  for (const auto& [name, value] : object.items()) {
    const std::string* const text = textOf(value);
    if (name == "address") {
      if (text == nullptr || !isName(*text, ".:%-_"))
        return "the address must be a host name or an IP address such as 192.168.123.1";
      robot.address = *text;
    } else if (name == "user") {
      if (text == nullptr || !isName(*text, "._-"))
        return "the user must be a name of letters and digits such as darwin";
      robot.user = *text;
    } else if (name == "key") {
      if (std::string why = takePath(value, "key", robot.key); !why.empty()) return why;
    } else if (name == "port") {
      if (!value.is_number_integer() || value.get<std::int64_t>() < 0 || value.get<std::int64_t>() > 65535)
        return "the port must be a number from 1 to 65535, or 0 for the default";
      robot.port = value.get<std::uint16_t>();
    } else {
      return "unknown member of \"robot\"; use address, user, key and port";
    }
  }
  return robot.address.empty() || robot.user.empty() ? "a robot requires an address and a user" : "";
}

Json jsonOf(const RobotAddress& robot) {
  return {{"address", robot.address}, {"user", robot.user}, {"key", robot.key}, {"port", robot.port}};
}

std::optional<TransferMessage> parseTransfer(std::string_view text, std::string& why) {
  const Json message = Json::parse(text.begin(), text.end(), nullptr, false);
  why = messages::kInvalidTransferRequest;
  if (!message.is_object() || message.size() != 1) return std::nullopt;
  TransferMessage request;
  const std::string& name = message.items().begin().key();
  const Json& value = message.front();
  if (name == "start") {
    why = takeStart(value, request.start.emplace());
  } else if (name == "forget") {
    why = takeRobot(value, request.forget.emplace());
  } else if (name == "cancel") {
    why = takeFlag(value, "cancel", request.cancel);
  } else if (name == "more") {
    why = value.is_number_unsigned() ? "" : "\"more\" must be the number of a line";
    if (why.empty()) request.more = value.get<std::uint64_t>();
  }
  if (!why.empty()) return std::nullopt;
  return request;
}

}  // namespace darwinop::window
