// FILE argument of `darwinop motion`: a motion file, or 'own' for the built-in pages.
#pragma once

#include <stdexcept>
#include <string>

#include "managers/motion/pages/own_pages.hpp"
#include "managers/motion_text/motion_file.hpp"

namespace darwinop::motion {

/// Throws like readMotionFile(). The built-in pages count as text.
inline MotionFile openMotions(const std::string& file) {
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
