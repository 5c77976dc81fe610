// Modified copies of shipped twin models in a temporary folder.
#pragma once

#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>

#include "support/temporary_folder.hpp"
#include "support/text_of.hpp"

namespace darwinop::experiments {

class Models {
 public:
  Models() { std::filesystem::copy_file(shipped("darwin-op.xml"), folder_ / "darwin-op.xml"); }

  /// Argument of --robot: the shipped model with one line changed.
  [[nodiscard]] std::string copy(const std::string& model, const std::string& line, const std::string& instead) const {
    std::string text = read(model);
    const std::size_t at = text.find(line);
    if (at == std::string::npos) throw std::logic_error(model + " has no line " + line);
    return write(text.replace(at, line.size(), instead));
  }
  /// The same with additional lines.
  [[nodiscard]] std::string with(const std::string& model, const std::string& lines) const {
    return write(read(model) + "\n" + lines);
  }

 private:
  static std::filesystem::path shipped(const std::string& file) {
    return std::filesystem::path{DARWINOP_TWIN_MODELS} / file;
  }
  static std::string read(const std::string& model) { return textOf(shipped(model + ".ini")); }
  [[nodiscard]] std::string write(const std::string& text) const {
    std::ofstream{folder_ / "mine.ini"} << text;
    return "twin:" + (folder_ / "mine.ini");
  }

  TemporaryFolder folder_;
};

}  // namespace darwinop::experiments
