// Parser of INI texts on top of inih: no line is ignored; the first error is thrown with file and line.
#include "core/text/ini_text.hpp"

#include <ini.h>

#include <algorithm>
#include <exception>
#include <stdexcept>

#include "core/text/ini_lines.hpp"

namespace darwinop::text {
namespace {

/// One pass over one text. inih is C: nothing may be thrown through it, so the first error is kept.
class Pass {
 public:
  Pass(std::string_view text, const std::string& file, IniReader& reader)
      : lines_{text}, file_{file}, reader_{reader} {}

  void run() {
    ini_parse_stream(&Pass::nextLine, this, &Pass::takePair, this);
    if (lines_.cut() > 0) throw std::runtime_error(where(file_, lines_.cut()) + ": the line is too long");
    if (!error_.empty()) throw std::runtime_error(error_);
  }

 private:
  static char* nextLine(char* into, int size, void* self) {
    auto* const pass = static_cast<Pass*>(self);
    char* const line = pass->lines_.next(into, size);
    if (line != nullptr) pass->keepingErrors([=] { pass->look(line); });
    return line;
  }

  static int takePair(void* self, const char*, const char* key, const char* value) {
    auto* const pass = static_cast<Pass*>(self);
    pass->keepingErrors([=] { pass->reader_.pair(pass->section_, key, withoutQuotes(value), pass->lines_.number()); });
    return 1;
  }

  /// Finds what inih ignores without an error.
  void look(std::string_view line) {
    if (line.starts_with('[')) {
      const auto end = line.find(']');
      if (end == line.npos) throw std::runtime_error("the section's closing bracket ] is missing");
      if (line.find_first_of("=:", end) != line.npos) throw std::runtime_error("put the key into a line of its own");
      const auto rest = line.find_first_not_of(" \t\r\n", end + 1);
      if (rest != line.npos && line[rest] != ';' && line[rest] != '#')
        throw std::runtime_error("there is something behind the section's closing bracket ]");
      section_ = line.substr(1, end - 1);
      reader_.section(section_, lines_.number());
    } else if (!line.empty() && line.find_first_of("=:") == line.npos) {
      reader_.stray(section_, line, lines_.number());
    }
  }

  template <class Action>
  void keepingErrors(const Action& action) noexcept {
    if (!error_.empty()) return;  // the first error counts
    try {
      action();
    } catch (const std::exception& wrong) {
      error_ = where(file_, lines_.number()) + ": " + std::string{withoutFile(wrong.what())};
    }
  }

  IniLines lines_;
  const std::string& file_;
  IniReader& reader_;
  std::string section_, error_;
};

}  // namespace

std::string where(const std::string& file, int line) {
  return file + ", line " + std::to_string(line);
}

void readIni(std::string_view text, const std::string& file, IniReader& reader) {
  if (const auto nul = text.find('\0'); nul != text.npos)
    throw std::runtime_error(where(file, 1 + static_cast<int>(std::count(text.begin(), text.begin() + nul, '\n'))) +
                             ": there is a zero byte, so this is not a text file, or a damaged one");
  Pass{text, file, reader}.run();
}

std::string_view withoutFile(std::string_view sentence) {
  constexpr std::string_view kFile = "config.ini, ";
  if (sentence.starts_with(kFile)) sentence.remove_prefix(kFile.size());
  return sentence;
}

}  // namespace darwinop::text
