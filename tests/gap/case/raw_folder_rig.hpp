// A folder of logs that gets its first files from a test.
#pragma once

#include <gtest/gtest.h>

#include <fstream>
#include <string>

#include "gap/case/bam_text.hpp"
#include "gap/case/raw_folder.hpp"
#include "support/replaced.hpp"
#include "support/temporary_folder.hpp"

namespace darwinop::gap {

struct RawFolderTest : testing::Test {
  const TemporaryFolder folder, out;

  RawFolderTest() { write(out / "model.ini", "[model]\nname = any\n"); }

  static void write(const std::string& path, const std::string& text) { std::ofstream{path} << text; }
  /// A log of that gain and payload.
  void addLog(const std::string& name, int kp, const std::string& mass_kg) const {
    const std::string head = "\"kp\": " + std::to_string(kp) + ", \"motor\": \"mx28\"";
    write(folder / (name + ".json"), replaced(bamText(zero, zero, head), "\"mass\": 0.5", "\"mass\": " + mass_kg));
  }
  [[nodiscard]] FolderCase read(bool all_logs = false) const {
    return readRawFolder(
        {.folder = folder / "", .model = out / "model.ini", .declared = {}, .held_out = {}, .all_logs = all_logs});
  }
};

}  // namespace darwinop::gap
