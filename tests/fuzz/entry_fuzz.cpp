// Host and Origin headers of the window: only local callers and its own page pass.
#include <cstdint>
#include <cstdlib>
#include <regex>
#include <string>

#include "hal/net/web/entry.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string bytes{reinterpret_cast<const char*>(data), size};
  const std::size_t cut = bytes.find('\n');
  darwinop::web::Knock knock{.host = std::string_view{bytes}.substr(0, cut), .origin = {}};
  if (cut != std::string::npos) knock.origin = std::string_view{bytes}.substr(cut + 1);
  if (size > 300 || !darwinop::web::refusal({.own_origin = true}, knock).empty()) return 0;
  static const std::regex known{R"(((\d{1,3}\.){3}\d{1,3}|localhost)(:\d*)?)", std::regex::icase};
  if (!std::regex_match(std::string{knock.host}, known)) std::abort();
  const std::regex own{"http://" + std::regex_replace(std::string{knock.host}, std::regex{"\\."}, "\\."),
                       std::regex::icase};
  if (knock.origin && !std::regex_match(std::string{*knock.origin}, own)) std::abort();
  return 0;
}
