// Text without regard to upper and lower case, for the keys of settings files.
#pragma once

#include <string>
#include <string_view>

namespace darwinop::text {

/// `text` in lower case. ASCII letters only.
std::string lowered(std::string_view text);

}  // namespace darwinop::text
