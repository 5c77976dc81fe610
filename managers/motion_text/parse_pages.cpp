// Reads pages from text, line by line. The first thing that is wrong ends it.
#include <algorithm>
#include <optional>
#include <set>
#include <stdexcept>

#include "core/text/number_text.hpp"
#include "managers/motion_text/page_section.hpp"
#include "managers/motion_text/page_text.hpp"
#include "managers/motion_text/values.hpp"

namespace darwinop::motion {

namespace {

/// Without what follows a # that is not in quotes.
std::string_view withoutRemark(std::string_view line) {
  bool quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '"') quoted = !quoted;
    if (line[i] == '#' && !quoted) line = line.substr(0, i);
  }
  return text::withoutBlanks(line);
}

class Reader {
 public:
  explicit Reader(const std::string& file) : file_{file} {
    for (std::size_t i = 0; i < kPages; ++i) pages_.push_back(unmentionedPage(i));
  }

  void take(std::string_view line) {
    ++line_;
    line = withoutRemark(line);
    if (line_ > 1 && line.starts_with('[')) endSection();
    try {
      understand(line);
    } catch (const std::runtime_error& why) {
      refuse(line_, why.what());
    }
  }

  PageFile finish() {
    if (line_ == 0) take("");  // not even a title
    endSection();
    return std::move(pages_);
  }

 private:
  [[noreturn]] void refuse(int line, const std::string& why) const {
    const std::string page = section_ ? ", page " + std::to_string(section_->number()) : std::string{};
    throw std::runtime_error(file_ + ", line " + std::to_string(line) + page + ": " + why);
  }

  void understand(std::string_view line) {
    if (line_ == 1) {
      if (line != kTextTitle)
        throw std::runtime_error("the text of a motion file begins with the line '" + std::string{kTextTitle} + "'");
    } else if (line.starts_with('[')) {
      beginSection(line);
    } else if (!line.empty()) {
      const std::size_t equals = line.find('=');
      if (equals == line.npos) throw std::runtime_error("write FIELD = VALUE, or [page NUMBER]");
      if (!section_) throw std::runtime_error("write [page NUMBER] before the first field");
      section_->set(std::string{text::withoutBlanks(line.substr(0, equals))},
                    text::withoutBlanks(line.substr(equals + 1)));
    }
  }

  void beginSection(std::string_view heading) {
    constexpr std::string_view kBegin = "[page ";
    std::optional<std::uint8_t> number;
    if (heading.starts_with(kBegin) && heading.ends_with(']'))
      number = countFromText(text::withoutBlanks(heading.substr(kBegin.size(), heading.size() - kBegin.size() - 1)));
    if (!number) throw std::runtime_error("write [page NUMBER] with a number from 0 to 255");
    if (!begun_.insert(*number).second)
      throw std::runtime_error("page " + std::to_string(*number) + " has been there before");
    section_.emplace(*number);
    heading_line_ = line_;
  }

  void endSection() {
    if (!section_) return;
    try {
      pages_[section_->number()] = section_->finish();
    } catch (const std::runtime_error& why) {
      refuse(heading_line_, why.what());
    }
    section_.reset();
  }

  std::string file_;
  PageFile pages_;
  std::optional<PageSection> section_;
  std::set<int> begun_;
  int line_ = 0, heading_line_ = 0;
};

}  // namespace

PageFile parsePages(std::string_view text, const std::string& file) {
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";  // some editors begin files with it
  if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
  Reader reader{file};
  while (!text.empty()) {
    const std::size_t length = std::min(text.find('\n'), text.size());
    reader.take(text.substr(0, length));
    text.remove_prefix(std::min(length + 1, text.size()));
  }
  return reader.finish();
}

}  // namespace darwinop::motion
