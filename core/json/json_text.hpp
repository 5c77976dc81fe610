// Writes JSON text. Strings may come from files, shared memory or other programs and hold invalid UTF-8.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace darwinop {

/// Always valid UTF-8: an invalid byte becomes U+FFFD, where dump() alone throws. `indent`: blanks per level; -1: one
/// line. `ascii`: other characters as \uNNNN.
template <class Json>
std::string jsonText(const Json& value, int indent = -1, bool ascii = false) {
  return value.dump(indent, ' ', ascii, Json::error_handler_t::replace);
}

}  // namespace darwinop
