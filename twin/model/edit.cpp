// Edits the text of a model file: one effect's section comes, changes or goes, and no other byte.
#include <algorithm>
#include <array>
#include <stdexcept>

#include "core/text/ini_lines.hpp"
#include "core/text/number_text.hpp"
#include "twin/model/section_text.hpp"

namespace darwinop::twin {
namespace {

constexpr const char* kFile = "the model";

/// The file in lines, each with its line end, and the sections in it.
class Page {
 public:
  struct Section {
    SectionName name;
    std::size_t begin, end;  // lines: with the comments right above it and those right below its last key
  };

  explicit Page(std::string_view text) {
    parseModel(text, kFile);  // what is not sound is not edited
    text::IniLines contents{text};
    std::array<char, 4096> content{};
    while (contents.next(content.data(), content.size()) != nullptr) {
      const std::string_view raw = text.substr(0, std::min(text.find('\n'), text.size() - 1) + 1);
      text.remove_prefix(raw.size());
      lines_.emplace_back(raw);
      contents_.emplace_back(content.data());
    }
    crlf_ = !lines_.empty() && lines_.front().ends_with("\r\n");
    std::vector<std::size_t> headers;
    for (std::size_t i = 0; i < lines_.size(); ++i)
      if (contents_[i].starts_with('[')) headers.push_back(i);
    for (std::size_t i = 0; i < headers.size(); ++i)
      sections_.push_back(extent(headers[i], i + 1 < headers.size() ? headers[i + 1] : lines_.size()));
  }

  [[nodiscard]] const Section* find(const SectionName& name) const {
    const auto found = std::ranges::find(sections_, name, &Section::name);
    return found == sections_.end() ? nullptr : &*found;
  }

  void remove(const Section& section) {
    const bool blank_above = section.begin > 0 && isBlank(section.begin - 1);
    lines_.erase(at(section.begin - (blank_above ? 1 : 0)), at(section.end));
  }

  void replace(const Section& section, const std::vector<std::string>& lines) {
    const bool ended = lines_[section.end - 1].ends_with('\n');
    lines_.erase(at(section.begin), at(section.end));
    insert(section.begin, lines);
    if (!ended) lines_.back().resize(lines_.back().size() - lineEnd().size());
  }

  /// Below the other effects, or at the end.
  void add(std::vector<std::string> lines) {
    const auto last = std::ranges::find_if(sections_.rbegin(), sections_.rend(),
                                           [](const Section& section) { return section.name.info != nullptr; });
    std::size_t where = last != sections_.rend() ? last->end : lines_.size();
    while (where > 0 && isBlank(where - 1)) --where;
    if (where > 0 && !lines_[where - 1].ends_with('\n')) lines_[where - 1] += lineEnd();
    lines.insert(lines.begin(), "");
    insert(where, lines);
  }

  [[nodiscard]] std::string text() const {
    std::string out;
    for (const std::string& line : lines_) out += line;
    parseModel(out, kFile);  // a value that no file may have is refused here
    return out;
  }

 private:
  [[nodiscard]] bool isBlank(std::size_t line) const { return text::withoutBlanks(lines_[line]).empty(); }
  [[nodiscard]] bool isComment(std::size_t line) const { return contents_[line].empty() && !isBlank(line); }
  [[nodiscard]] std::string lineEnd() const { return crlf_ ? "\r\n" : "\n"; }
  [[nodiscard]] std::vector<std::string>::iterator at(std::size_t line) {
    return lines_.begin() + static_cast<std::ptrdiff_t>(line);
  }

  void insert(std::size_t where, const std::vector<std::string>& lines) {
    std::vector<std::string> ended;
    ended.reserve(lines.size());
    for (const std::string& line : lines) ended.push_back(line + lineEnd());
    lines_.insert(at(where), ended.begin(), ended.end());
  }

  [[nodiscard]] Section extent(std::size_t header, std::size_t next) const {
    const std::string& line = contents_[header];
    Section section{sectionFrom(std::string_view{line}.substr(1, line.find(']') - 1)), header, header + 1};
    while (section.begin > 0 && isComment(section.begin - 1)) --section.begin;
    std::size_t last = next - 1;
    while (contents_[last].empty()) --last;  // ends at the header
    section.end = last + 1;
    while (section.end < next && isComment(section.end)) ++section.end;
    // Comments right above the next header are that one's.
    if (section.end == next && next < lines_.size()) section.end = last + 1;
    return section;
  }

  std::vector<std::string> lines_, contents_;
  std::vector<Section> sections_;
  bool crlf_ = false;
};

/// One line each: what would end a line within does so.
void addComments(std::vector<std::string>& lines, const std::vector<std::string>& comments) {
  for (const std::string& comment : comments) {
    std::string line = ";";
    for (const char c : comment + '\n') {
      if (c == '\n') {
        lines.push_back(line);
        line = ";";
      } else if (c != '\r') {
        line += line.size() == 1 ? std::string{' ', c} : std::string{c};
      }
    }
  }
}

}  // namespace

std::string withEffect(std::string_view text, const EffectSetting& setting, const std::vector<std::string>& comments) {
  std::vector<std::string> lines;
  addComments(lines, comments);
  for (const std::string& line : sectionLines(setting)) lines.push_back(line);
  Page page{text};
  if (const Page::Section* const old = page.find({.info = setting.info, .joint = setting.joint}))
    page.replace(*old, lines);
  else
    page.add(lines);
  return page.text();
}

std::string withoutEffect(std::string_view text, std::string_view id, std::optional<Joint> joint) {
  std::string header = "effect " + std::string{id};
  if (joint) (header += ' ') += row(*joint).name;
  Page page{text};
  const Page::Section* const section = page.find(sectionFrom(header));
  if (section == nullptr)
    throw std::runtime_error(std::string{kFile} + " has no section [" + header + "], so there is nothing to take out");
  page.remove(*section);
  return page.text();
}

}  // namespace darwinop::twin
