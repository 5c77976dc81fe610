// Prints the tables of docs/gap/export.md: what each target can hold.
#include <iostream>

#include "gap/export/body/body_holds.hpp"

int main() {
  std::cout << darwinop::gap::holdingsAsMarkdown() << '\n' << darwinop::gap::keyHoldingsAsMarkdown();
}
