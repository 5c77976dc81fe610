#include "hil-mocks/camera/camera_settings.hpp"

#include <cstdlib>
#include <filesystem>
#include <stdexcept>

namespace darwinop::hil {
namespace {

std::string libraryPath() {
  const std::filesystem::path self = std::filesystem::read_symlink("/proc/self/exe");
  std::filesystem::path path = self.parent_path().parent_path() / "lib" / "libdarwinop-virtual-camera.so";
  if (!std::filesystem::exists(path)) throw std::runtime_error(path.string() + " not found: run ./dev build");
  if (path.string().find_first_of(" :") != std::string::npos)
    throw std::runtime_error(path.string() +
                             " cannot be preloaded: its path contains a blank or a colon; build in another folder");
  return path;
}

}  // namespace

std::vector<std::string> cameraSettings(const std::string& file, const std::string& device) {
  const std::string library = libraryPath();
  const char* const others = std::getenv("LD_PRELOAD");
  const bool alone = others == nullptr || *others == '\0';
  // After other libraries: a sanitizer's must be the first.
  return {"LD_PRELOAD=" + (alone ? library : std::string{others} + ":" + library), "DARWINOP_VIRTUAL_CAMERA=" + file,
          "DARWINOP_VIRTUAL_CAMERA_DEVICE=" + device};
}

}  // namespace darwinop::hil
