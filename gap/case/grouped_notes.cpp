// The same note about many logs as one.
#include "gap/case/grouped_notes.hpp"

#include <algorithm>
#include <cctype>

#include "gap/case/messages.hpp"

namespace darwinop::gap {
namespace {

/// What a note says of its log: all behind "a.json: " or "a.csv, line 3: ". The whole note if it begins with no log.
std::string_view saidIn(std::string_view note) {
  std::string_view of = note;
  if (of.starts_with(messages::kLeftOut)) of.remove_prefix(std::string_view{messages::kLeftOut}.size());
  const std::size_t end = of.find(": ");
  std::string_view file = of.substr(0, end);
  for (const std::string_view place : {", line ", ", entries["}) file = file.substr(0, file.rfind(place));
  const bool of_log = end != of.npos && (file.ends_with(".json") || file.ends_with(".csv"));
  return of_log ? of.substr(end + 2) : note;
}

/// What several notes have in common, whose measured numbers differ. Numbers of a note about no log stay.
std::string patternOf(const std::string& note) {
  const std::string_view said = saidIn(note);
  if (said.size() == note.size()) return note;
  std::string pattern = note.starts_with(messages::kLeftOut) ? messages::kLeftOut : "";
  for (std::size_t i = 0; i < said.size();) {
    const std::size_t digit = said[i] == '-' ? i + 1 : i;
    const bool is_number = digit < said.size() && std::isdigit(static_cast<unsigned char>(said[digit])) != 0;
    pattern += is_number ? '#' : said[i];
    i = is_number ? std::min(said.find_first_not_of("0123456789.", digit), said.size()) : i + 1;
  }
  return pattern;
}

struct NoteGroup {
  std::string first, pattern;
  std::size_t more = 0;
  bool differs = false;  // in numbers
};

}  // namespace

std::vector<std::string> grouped(const std::vector<std::string>& notes) {
  std::vector<NoteGroup> groups;
  for (const std::string& note : notes) {
    std::string pattern = patternOf(note);
    const auto same = std::ranges::find(groups, pattern, &NoteGroup::pattern);
    if (same == groups.end()) {
      groups.push_back({.first = note, .pattern = std::move(pattern)});
    } else {
      ++same->more;
      same->differs = same->differs || saidIn(note) != saidIn(same->first);
    }
  }
  std::vector<std::string> out;
  for (NoteGroup& group : groups) {
    if (group.more > 0)
      group.first += " (and " + std::to_string(group.more) + (group.more == 1 ? " more log" : " more logs") +
                     (group.differs ? ", each with its own numbers)" : ")");
    out.push_back(std::move(group.first));
  }
  return out;
}

}  // namespace darwinop::gap
