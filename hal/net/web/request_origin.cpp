// Host and Origin check of a request.
#include "hal/net/web/request_origin.hpp"

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

bool isOwnName(const OriginRules& rules, std::string_view host) {
  if (host.find('\0') != std::string_view::npos) return false;
  const std::string_view name = withoutPort(host);
  return isIpv4(name) || sameName(name, "localhost") ||
         std::ranges::any_of(rules.hosts, [name](const std::string& own) { return sameName(own, name); });
}

}  // namespace

std::string refusal(const OriginRules& rules, const RequestOrigin& request_origin) {
  if (!isOwnName(rules, request_origin.host)) return "unknown host name in the request; " + rules.host_remedy;
  if (!request_origin.origin) return {};
  const std::string_view origin = *request_origin.origin;
  constexpr std::string_view kScheme = "http://";
  if (rules.own_origin && origin.starts_with(kScheme) && sameName(origin.substr(kScheme.size()), request_origin.host))
    return {};
  if (std::ranges::find(rules.origins, origin) != rules.origins.end()) return {};
  return "pages of this origin are not allowed; " + rules.origin_remedy;
}

}  // namespace darwinop::web
