// Unguessable part of the page's address.
#pragma once

#include <string>

namespace darwinop::window {

/// 128 random bits of the kernel as 32 hexadecimal digits; new at each call. Throws std::runtime_error.
std::string newSecret();

}  // namespace darwinop::window
