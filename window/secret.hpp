// What only those know who were told the address of the page.
#pragma once

#include <string>

namespace darwinop::window {

/// 128 bits from the kernel as 32 letters and digits; new at each call. Throws std::runtime_error.
std::string newSecret();

}  // namespace darwinop::window
