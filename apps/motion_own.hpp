// FILE of `darwinop motion`: a motion file, or the word that stands for the own pages.
#pragma once

#include <stdexcept>
#include <string>

#include "managers/motion/pages/own_pages.hpp"
#include "managers/motion_text/motion_file.hpp"

namespace darwinop::motion {

/// Throws as readMotionFile(). The own pages count as text.
inline MotionFile openMotions(const std::string& file) {
  return file == kOwn ? MotionFile{ownPages(), true} : readMotionFile(file);
}

/// The page, which must hold something; throws std::runtime_error. `file` is its name.
inline const Page& usedPage(const PageFile& pages, int number, const std::string& file) {
  const Page& page = pages.at(static_cast<std::size_t>(number));
  if (!page.canPlay())
    throw std::runtime_error(file + ": page " + std::to_string(number) +
                             " holds nothing to play; 'darwinop motion list " + file + "' shows those that do");
  return page;
}

}  // namespace darwinop::motion
