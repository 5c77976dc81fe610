// Models of the twin that differ from a delivered one, in a folder of their own.
#pragma once

#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>

#include "support/temporary_folder.hpp"

namespace darwinop::experiments {

class Models {
 public:
  Models() { std::filesystem::copy_file(shipped("darwin-op.xml"), folder_ / "darwin-op.xml"); }

  /// As --robot takes it: the delivered model with one line changed.
  [[nodiscard]] std::string copy(const std::string& model, const std::string& line, const std::string& instead) const {
    std::string text = read(model);
    const std::size_t at = text.find(line);
    if (at == std::string::npos) throw std::logic_error(model + " has no line " + line);
    return write(text.replace(at, line.size(), instead));
  }
  /// The same with some lines more.
  [[nodiscard]] std::string with(const std::string& model, const std::string& lines) const {
    return write(read(model) + "\n" + lines);
  }

 private:
  static std::filesystem::path shipped(const std::string& file) {
    return std::filesystem::path{DARWINOP_TWIN_MODELS} / file;
  }
  static std::string read(const std::string& model) {
    std::ostringstream text;
    text << std::ifstream{shipped(model + ".ini")}.rdbuf();
    return text.str();
  }
  [[nodiscard]] std::string write(const std::string& text) const {
    std::ofstream{folder_ / "mine.ini"} << text;
    return "twin:" + (folder_ / "mine.ini");
  }

  TemporaryFolder folder_;
};

}  // namespace darwinop::experiments
