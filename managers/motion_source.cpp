// Selects the pages of a motion manager.
#include "managers/motion_source.hpp"

#include <exception>
#include <filesystem>

#include "managers/motion/pages/own_pages.hpp"
#include "managers/motion_text/motion_file.hpp"
#include "webots/notices.hpp"

namespace managers {

namespace motion = darwinop::motion;
using darwinop::webots_api::warnOnce;

namespace {

constexpr const char* kFileName = "motion_4096.bin";

/// The built-in pages; static, so the deleter does nothing.
MotionPages ownMotionPages() {
  return {&motion::ownPages(), [](const motion::PageFile*) {}};
}

/// True also for a dangling symbolic link.
bool isThere(const std::string& path) {
  std::error_code unknown;
  return std::filesystem::symlink_status(path, unknown).type() != std::filesystem::file_type::not_found;
}

}  // namespace

MotionPages readMotionPages(const std::string& custom, const std::string& directory) try {
  if (custom == motion::kOwn) return ownMotionPages();
  const std::string path = custom.empty() ? directory + kFileName : custom;
  if (custom.empty() && !isThere(path)) {
    warnOnce("MotionManager: cannot find " + path + ": the built-in pages are played (darwinop motion list own)");
    return ownMotionPages();
  }
  return std::make_shared<motion::PageFile>(motion::readMotionFile(path).pages);
} catch (const std::exception& why) {
  warnOnce(std::string{"MotionManager: "} + why.what() + "; no page will be played");
  return nullptr;
}

}  // namespace managers
