// FILE argument of `darwinop motion`: a motion file, or 'own' for the built-in pages.
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "managers/motion/pages/own_pages.hpp"
#include "managers/motion_text/motion_file.hpp"
#include "motion_messages.hpp"

namespace darwinop::motion {

/// A file of webots::Motion. Throws like readBytes().
inline bool isMotionOfWebots(const std::string& file) {
  if (file == kOwn) return false;
  const std::vector<std::uint8_t> bytes = readBytes(file);
  constexpr std::string_view kHead = "#WEBOTS_MOTION";
  return std::string_view{reinterpret_cast<const char*>(bytes.data()), bytes.size()}.starts_with(kHead);
}

/// Throws std::runtime_error for such a file.
inline void refuseMotionOfWebots(const std::string& file) {
  if (isMotionOfWebots(file)) throw std::runtime_error(file + kOnlyPlayReads);
}

/// Throws like readMotionFile(). The built-in pages count as text.
inline MotionFile openMotions(const std::string& file) {
  refuseMotionOfWebots(file);
  return file == kOwn ? MotionFile{ownPages(), true} : readMotionFile(file);
}

/// The page; throws std::runtime_error if it is empty. `file` is for the message.
inline const Page& usedPage(const PageFile& pages, int number, const std::string& file) {
  const Page& page = pages.at(static_cast<std::size_t>(number));
  if (!page.canPlay())
    throw std::runtime_error(file + ": page " + std::to_string(number) +
                             " is empty; list the playable pages with 'darwinop motion list " + file + "'");
  return page;
}

}  // namespace darwinop::motion
