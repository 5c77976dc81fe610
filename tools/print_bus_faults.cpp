// Prints the faults that the doctor names, for docs/doctor.md.
#include <iostream>

#include "hal/cm730/diagnosis/bus_faults.hpp"

int main() {
  std::cout << "\n| Name | Fault | Fix | Virtual robot |\n|---|---|---|---|\n";
  for (const darwinop::cm730::BusFaultRow& row : darwinop::cm730::kBusFaultTable)
    std::cout << "| " << row.name << " | " << row.what << " | " << row.remedy << " |" << (row.shown.empty() ? "" : " ")
              << row.shown << " |\n";
}
