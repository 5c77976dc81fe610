// Prints the faults of docs/faults.md from core/faults.hpp.
#include <array>
#include <cctype>
#include <iostream>
#include <sstream>
#include <string>
#include <string_view>

#include "core/faults.hpp"

namespace {

using namespace darwinop;

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

}  // namespace

int main() {
  std::cout << '\n' << wrapped("Checked, and times counted, in " + checkedWhen() + ".");
  for (const FaultRow& fault : kFaultTable) print(std::cout, fault);
}
