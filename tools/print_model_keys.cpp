// Prints the table of docs/twin/models.md: keys of a model file.
#include <iostream>

#include "twin/model/keys.hpp"

int main() {
  std::cout << darwinop::twin::keysAsMarkdown();
}
