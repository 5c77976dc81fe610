// Host and Origin check of a request, before anything else in it is used.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace darwinop::web {

/// Headers that a page cannot make a browser forge.
struct RequestOrigin {
  std::string_view host;                   // header Host: the name by which this computer was addressed
  std::optional<std::string_view> origin;  // header Origin: the page that asks; programs send none
};

struct OriginRules {
  std::vector<std::string> origins{};  // allowed, exactly as browsers write them: "http://127.0.0.1:8080"
  bool own_origin = false;             // allow pages of this server
  std::vector<std::string> hosts{};    // names of this computer besides localhost
  // What a person can do about a refusal: parts of its sentence.
  std::string host_remedy = "use the IP address, or allow the name with --host";
  std::string origin_remedy = "allow it with --origin, exactly as the browser writes it";
};

/// Empty: accepted. Otherwise the reason, for the response.
/// Host: after DNS rebinding a page addresses this computer by the page's name, so names must be known; IP addresses
/// are accepted. The port is ignored, because ssh -L changes it. Origin: any page may open a WebSocket to any address,
/// including this computer's loopback and forwarded ports.
[[nodiscard]] std::string refusal(const OriginRules& rules, const RequestOrigin& request_origin);

}  // namespace darwinop::web
