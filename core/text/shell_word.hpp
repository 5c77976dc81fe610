// A word of a command line.
#pragma once

#include <string>
#include <string_view>

namespace darwinop::text {

/// Quoted where a shell would read it otherwise: "it's" is 'it'\''s'. A leading ~ is quoted too: it stands for itself.
inline std::string shellWord(std::string_view word) {
  constexpr std::string_view kPlain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-./=:,@%+";
  if (!word.empty() && word.find_first_not_of(kPlain) == word.npos) return std::string{word};
  std::string quoted = "'";
  for (const char letter : word) quoted += letter == '\'' ? std::string{R"('\'')"} : std::string{letter};
  return quoted + "'";
}

}  // namespace darwinop::text
