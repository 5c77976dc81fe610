// The same note about many logs as one.
#include <algorithm>

#include "gap/case/raw_folder.hpp"

namespace darwinop::gap {
namespace {

/// What a note says of its log: all behind "a.json: ". The whole note if it begins with no log.
std::string_view saidIn(std::string_view note) {
  const std::size_t end = note.find(": ");
  const std::string_view file = note.substr(0, end);
  const bool of_log = end != note.npos && (file.ends_with(".json") || file.ends_with(".csv"));
  return of_log ? note.substr(end + 2) : note;
}

}  // namespace

std::vector<std::string> grouped(const std::vector<std::string>& notes) {
  std::vector<std::string> out;
  std::vector<std::size_t> more;
  for (const std::string& note : notes) {
    const auto same = std::ranges::find(out, saidIn(note), saidIn);
    if (same == out.end())
      out.push_back(note), more.push_back(0);
    else
      ++more[static_cast<std::size_t>(same - out.begin())];
  }
  for (std::size_t i = 0; i < out.size(); ++i)
    if (more[i] > 0) out[i] += " (and " + std::to_string(more[i]) + " more logs)";
  return out;
}

}  // namespace darwinop::gap
