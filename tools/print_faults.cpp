// print_faults PAGE          docs/faults.md with its faults renewed from core/faults.hpp: the text up to the mark stays
// print_faults --check PAGE  exit code 1 unless PAGE is that
#include <cctype>
#include <fstream>
#include <iostream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/faults.hpp"

namespace {

using namespace darwinop;

constexpr std::string_view kMark = "<!-- faults: made by ./dev docs from core/faults.hpp -->\n";
constexpr std::array<std::string_view, 6> kReactions{"Report", "Slow", "Hold", "Kneel", "Limp", "Stop sending"};
constexpr std::array<std::string_view, 4> kChecked{"each cycle", "cycles in which the board answers",
                                                   "cycles in which the servo answers", "polls of the servo"};

std::string sentence(std::string_view text) {
  std::string out{text};
  out.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(out.front())));
  return out + '.';
}

/// Lines of at most 120 characters.
std::string wrapped(const std::string& text) {
  constexpr std::size_t kWidth = 120;
  std::istringstream words{text};
  std::string out, line;
  for (std::string word; words >> word;) {
    if (!line.empty() && line.size() + 1 + word.size() > kWidth) {
      out += line + '\n';
      line.clear();
    }
    line += (line.empty() ? "" : " ") + word;
  }
  return out + line + '\n';
}

void print(std::ostream& out, const FaultRow& fault) {
  std::string text{kReactions.at(static_cast<std::size_t>(fault.reaction))};
  text += std::string{fault.latched ? ", latched" : ""} + ". " + sentence(fault.meaning);
  if (!fault.ends.empty()) text += (fault.latched ? " Can be reset " : " Ends ") + std::string{fault.ends} + ".";
  if (!fault.details.empty()) text += " " + std::string{fault.details};
  out << "\n## " << static_cast<int>(fault.fault) << ' ' << fault.name << '\n'
      << wrapped(text) << wrapped("Fix: " + std::string{fault.remedy} + ".");
}

/// "each cycle: 10, 12; polls of the servo: 22".
std::string checkedWhen() {
  std::string text;
  for (std::size_t i = 0; i < kChecked.size(); ++i) {
    std::string numbers;
    for (const FaultRow& fault : kFaultTable)
      if (static_cast<std::size_t>(fault.checked) == i)
        numbers += (numbers.empty() ? ": " : ", ") + std::to_string(static_cast<int>(fault.fault));
    text += (text.empty() ? "" : "; ") + std::string{kChecked.at(i)} + numbers;
  }
  return text;
}

std::string renewed(const std::string& page) {
  const auto mark = page.find(kMark);
  if (mark == page.npos) throw std::runtime_error("the page has no line '" + std::string{kMark} + "'");
  std::ostringstream out;
  out << page.substr(0, mark + kMark.size());
  out << '\n' << wrapped("Checked, and times counted, in " + checkedWhen() + ".");
  for (const FaultRow& fault : kFaultTable) print(out, fault);
  return out.str();
}

int run(const std::vector<std::string>& arguments) {
  const bool check = arguments.size() == 2 && arguments.front() == "--check";
  if (!check && arguments.size() != 1) throw std::runtime_error("give PAGE or --check PAGE");
  std::ifstream file{arguments.back()};
  if (!file) throw std::runtime_error("cannot read " + arguments.back());
  std::ostringstream page;
  page << file.rdbuf();
  const std::string right = renewed(page.str());
  if (!check) std::cout << right;
  if (!check || page.str() == right) return 0;
  std::cerr << arguments.back() << " is out of date: run `./dev docs` and commit the result\n";
  return 1;
}

}  // namespace

int main(int count, char** arguments) try {
  return run({arguments + 1, arguments + count});
} catch (const std::exception& error) {
  std::cerr << "print_faults: " << error.what() << '\n';
  return 1;
}
