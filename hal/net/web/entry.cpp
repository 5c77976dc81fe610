#include "hal/net/web/entry.hpp"

#include <arpa/inet.h>

#include <algorithm>

namespace darwinop::web {
namespace {

char lowerLetter(char letter) {
  return letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter - 'A' + 'a') : letter;
}

bool sameName(std::string_view a, std::string_view b) {
  return std::ranges::equal(a, b, {}, lowerLetter, lowerLetter);
}

std::string_view withoutPort(std::string_view host) {
  const std::size_t colon = host.rfind(':');
  if (colon == std::string_view::npos) return host;
  const std::string_view port = host.substr(colon + 1);
  const bool digits = std::ranges::all_of(port, [](char c) { return c >= '0' && c <= '9'; });
  return digits ? host.substr(0, colon) : host;
}

bool isIpv4(std::string_view host) {
  in_addr address{};
  return inet_pton(AF_INET, std::string{host}.c_str(), &address) == 1;
}

bool isNameOfOurs(const EntryRules& rules, std::string_view host) {
  if (host.find('\0') != std::string_view::npos) return false;
  const std::string_view name = withoutPort(host);
  return isIpv4(name) || sameName(name, "localhost") ||
         std::ranges::any_of(rules.hosts, [name](const std::string& own) { return sameName(own, name); });
}

}  // namespace

std::string refusal(const EntryRules& rules, const Knock& knock) {
  if (!isNameOfOurs(rules, knock.host))
    return "this computer was called by a name that it does not know; call it by its number, or name it with --host";
  if (!knock.origin) return {};
  const std::string_view origin = *knock.origin;
  constexpr std::string_view kScheme = "http://";
  if (rules.own_origin && origin.starts_with(kScheme) && sameName(origin.substr(kScheme.size()), knock.host)) return {};
  if (std::ranges::find(rules.origins, origin) != rules.origins.end()) return {};
  return "a page of another origin may not look here; allow it with --origin, exactly as the browser writes it";
}

}  // namespace darwinop::web
