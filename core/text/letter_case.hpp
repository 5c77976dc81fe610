// Text without regard to upper and lower case, for the keys of settings files.
#pragma once

#include <string>
#include <string_view>

namespace darwinop::text {

/// `text` in lower case. ASCII letters only.
std::string lowered(std::string_view text);

/// The joint's own spelling: keys of an INI file may be written in any case. `key` itself when it names no joint.
std::string_view jointName(std::string_view key);

}  // namespace darwinop::text
