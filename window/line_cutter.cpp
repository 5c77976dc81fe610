#include "window/line_cutter.hpp"

#include <algorithm>

namespace darwinop::window {

void LineCutter::add(std::string_view bytes, const Take& take) {
  while (!bytes.empty()) {
    const std::size_t end = std::min(bytes.find('\n'), bytes.size());
    const std::size_t room = kLongest - line_.size();
    line_ += bytes.substr(0, std::min(end, room));
    cut_ = cut_ || end > room;
    if (end == bytes.size()) return;
    bytes.remove_prefix(end + 1);
    finish(take);
  }
}

void LineCutter::end(const Take& take) {
  if (!line_.empty()) finish(take);
}

void LineCutter::finish(const Take& take) {
  while (line_.ends_with('\r')) line_.pop_back();
  line_.erase(0, line_.rfind('\r') + 1);  // drawn over, as progress bars do
  if (cut_) line_ += "…";
  take(line_);
  line_.clear();
  cut_ = false;
}

}  // namespace darwinop::window
