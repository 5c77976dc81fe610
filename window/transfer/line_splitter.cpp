// Splits a program's output into lines.
#include "window/transfer/line_splitter.hpp"

#include <algorithm>

namespace darwinop::window {

void LineSplitter::add(std::string_view bytes, const OnLine& on_line) {
  while (!bytes.empty()) {
    const std::size_t end = std::min(bytes.find('\n'), bytes.size());
    const std::size_t room = kLongest - line_.size();
    line_ += bytes.substr(0, std::min(end, room));
    cut_ = cut_ || end > room;
    if (end == bytes.size()) return;
    bytes.remove_prefix(end + 1);
    finish(on_line);
  }
}

void LineSplitter::end(const OnLine& on_line) {
  if (!line_.empty()) finish(on_line);
}

void LineSplitter::finish(const OnLine& on_line) {
  while (line_.ends_with('\r')) line_.pop_back();
  line_.erase(0, line_.rfind('\r') + 1);  // overwritten, as by progress bars
  if (cut_) line_ += "…";
  on_line(line_);
  line_.clear();
  cut_ = false;
}

}  // namespace darwinop::window
