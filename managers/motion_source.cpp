// Selects the pages of a motion manager.
#include "managers/motion_source.hpp"

#include <cstdint>
#include <exception>
#include <filesystem>
#include <stdexcept>
#include <vector>

#include "managers/messages.hpp"
#include "managers/motion/pages/own_pages.hpp"
#include "managers/motion_text/check_pages.hpp"
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

/// A damaged page of a binary file is left empty, with a warning that names it; the others are good. Throws
/// std::runtime_error if the file is not a motion file.
MotionPages readPages(const std::string& path) {
  const std::vector<std::uint8_t> bytes = motion::readBytes(path);
  if (motion::isText(bytes)) return std::make_shared<motion::PageFile>(motion::readMotionFile(path).pages);
  auto pages = std::make_shared<motion::PageFile>();
  const std::vector<std::string> damages = motion::checkBytes(bytes, *pages);
  if (pages->empty()) throw std::runtime_error(path + ": " + damages.front());
  for (const std::string& damage : damages)
    warnOnce("MotionManager: " + path + ": " + damage + messages::kPageIsRefused);
  return pages;
}

}  // namespace

MotionPages readMotionPages(const std::string& custom, const std::string& directory) try {
  if (custom == motion::kOwn) return ownMotionPages();
  const std::string path = custom.empty() ? directory + kFileName : custom;
  if (custom.empty() && !isThere(path)) {
    warnOnce("MotionManager: cannot find " + path + ": the built-in pages are played (darwinop motion list own)");
    return ownMotionPages();
  }
  return readPages(path);
} catch (const std::exception& why) {
  warnOnce(std::string{"MotionManager: "} + why.what() + "; no page will be played");
  return nullptr;
}

}  // namespace managers
