#include "gap/report/report_folder.hpp"

#include <filesystem>
#include <stdexcept>
#include <system_error>

#include "hal/text_file.hpp"
#include "hal/write_text_file.hpp"

namespace darwinop::gap {

void writeReportFolder(const std::string& folder, const std::vector<std::pair<std::string, std::string>>& files) {
  constexpr const char* kRemedy = "; give another folder with --report";
  std::error_code wrong;
  std::filesystem::create_directories(folder, wrong);
  if (wrong) throw std::runtime_error("cannot create " + folder + ": " + wrong.message() + kRemedy);
  for (const auto& [name, text] : files) {
    const std::filesystem::path path = std::filesystem::path{folder} / name;
    if (const auto former = readTextFile(path, kAnyLength); former && *former != text) {
      std::filesystem::rename(path, path.string() + ".before", wrong);
      if (wrong) throw std::runtime_error("cannot replace " + path.string() + ": " + wrong.message() + kRemedy);
    }
    try {
      writeTextFile(path, text);
    } catch (const std::runtime_error& error) {
      throw std::runtime_error(error.what() + std::string{kRemedy});
    }
  }
}

}  // namespace darwinop::gap
