// Transfer channel: no command-line option that the page may not set.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "window/transfer/transfer_message.hpp"

namespace {

void expectWord(const std::string& word) {
  if (std::ranges::any_of(word, [](unsigned char letter) { return letter < ' '; })) __builtin_trap();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::string why;
  const auto words = darwinop::window::parseTransfer({reinterpret_cast<const char*>(data), size}, why);
  if (!words && why.empty()) __builtin_trap();
  if (!words || !words->start) return 0;
  const auto& start = *words->start;
  if (start.robot.user.empty() || start.robot.user[0] == '-') __builtin_trap();
  if (start.robot.address.empty() || start.robot.address[0] == '-') __builtin_trap();
  if (darwinop::window::hasController(start.action) == start.controller.empty()) __builtin_trap();
  for (const std::string& word :
       {start.robot.user, start.robot.address, start.robot.key, start.controller, start.host_key})
    expectWord(word);
  for (const std::string& word : start.arguments) expectWord(word);
  return 0;
}
