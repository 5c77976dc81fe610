// Writes numbered PNG files.
#include "twin/render/png_folder.hpp"

#include <array>
#include <cstdio>
#include <filesystem>
#include <stdexcept>

#include "twin/render/png.hpp"

namespace darwinop::twin {
namespace fs = std::filesystem;

PngFolder::PngFolder(std::string folder) : folder_{std::move(folder)} {
  std::error_code error;
  fs::create_directories(folder_, error);
  if (!fs::is_directory(folder_))
    throw std::runtime_error("cannot create the folder " + folder_ + " for the pictures" +
                             (error ? ": " + error.message() : std::string{}));
  for (const auto& entry : fs::directory_iterator{folder_})
    if (entry.path().filename().string().starts_with("frame_"))
      throw std::runtime_error("the folder " + folder_ + " already contains pictures (" +
                               entry.path().filename().string() + "); name another one, or empty it first");
}

void PngFolder::add(const RenderedPicture& picture) {
  std::array<char, 32> name{};
  std::snprintf(name.data(), name.size(), "frame_%05d.png", ++count_);
  writePng((fs::path{folder_} / name.data()).string(), picture);
}

std::string PngFolder::place() const {
  return folder_ + " (" + std::to_string(count_) + " PNG pictures)";
}

}  // namespace darwinop::twin
