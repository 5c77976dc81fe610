// Who may come in: judged by what a request says of itself, before anything else is looked at.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace darwinop::web {

/// What a browser cannot be made to lie about by a page.
struct Knock {
  std::string_view host;                   // the header Host: by which name this computer was called
  std::optional<std::string_view> origin;  // the header Origin: the page that asks; programs send none
};

struct EntryRules {
  std::vector<std::string> origins{};  // pages that may ask, exactly as browsers write them: "http://127.0.0.1:8080"
  bool own_origin = false;             // so may pages of this server
  std::vector<std::string> hosts{};    // names of this computer beside localhost
};

/// Empty: come in. Else a sentence for the one who knocks.
///
/// Host: a page whose name was made to lead here (DNS rebinding) calls this computer by that name, so names must be
/// known; a number is no name. The port is not looked at: ssh -L changes it. Origin: any page may open a WebSocket to
/// any address, this one's loopback and forwarded ports included.
[[nodiscard]] std::string refusal(const EntryRules& rules, const Knock& knock);

}  // namespace darwinop::web
