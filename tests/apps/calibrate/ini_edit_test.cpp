// Keys of robot.ini are changed in place, and the old file is never lost.
#include "apps/calibrate/ini_edit.hpp"

#include <gmock/gmock.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "apps/calibrate/opened_robot.hpp"
#include "hal/replace_file.hpp"
#include "hal/text_file.hpp"
#include "support/temporary_folder.hpp"
#include "support/unprivileged.hpp"

namespace darwinop::calibrate {
namespace {

constexpr const char* kText =
    "# my robot\n[Robot]\nport = /dev/ttyUSB1   # left socket\n\n[Offsets]\n# measured by hand\nNeck = 0.000\n"
    "head: 0.1\n\n; the end\n[Limits]\nNeck = -1, 1\n";

void write(const std::string& path, const std::string& text) {
  std::ofstream{path} << text;
}

TEST(IniEdit, ReplacesAKeyInItsSectionAndNothingElse) {
  EXPECT_EQ(withValues(kText, "offsets", {{"Neck", "0.012", "2026-11-26"}}),
            "# my robot\n[Robot]\nport = /dev/ttyUSB1   # left socket\n\n[Offsets]\n# measured by hand\n"
            "Neck = 0.012  # 2026-11-26\nhead: 0.1\n\n; the end\n[Limits]\nNeck = -1, 1\n");
}

TEST(IniEdit, AddsAKeyAfterTheLastOneOfItsSection) {
  EXPECT_EQ(withValues(kText, "Offsets", {{"Head", "0.2", ""}, {"FootR", "0.3", ""}}),
            "# my robot\n[Robot]\nport = /dev/ttyUSB1   # left socket\n\n[Offsets]\n# measured by hand\nNeck = 0.000\n"
            "Head = 0.2\nFootR = 0.3\n\n; the end\n[Limits]\nNeck = -1, 1\n");
}

TEST(IniEdit, AddsAMissingSectionAtTheEnd) {
  EXPECT_EQ(withValues("[Robot]\ngroup =", "Imu", {{"mounting", "0, 0, 0", ""}}),
            "[Robot]\ngroup =\n\n[Imu]\nmounting = 0, 0, 0\n");
  EXPECT_EQ(withValues("", "Imu", {{"mounting", "0, 0, 0", "why"}}), "[Imu]\nmounting = 0, 0, 0  # why\n");
}

TEST(ReplaceKeepingOld, KeepsEveryOldFileWithItsContentAndMode) {
  const TemporaryFolder folder;
  const std::string file = folder / "robot.ini";
  write(file, "first\n");
  chmod(file.c_str(), 0640);
  const std::string kept = replaceKeepingOld(file, "second\n", "20261126-170000");
  EXPECT_EQ(kept, file + ".before-20261126-170000");
  const std::string again = replaceKeepingOld(file, "third\n", "20261126-170000");  // within the same second
  EXPECT_EQ(readTextFile(kept), "first\n");
  EXPECT_EQ(readTextFile(again), "second\n");
  EXPECT_EQ(readTextFile(file), "third\n");
  struct stat about {};
  ASSERT_EQ(stat(file.c_str(), &about), 0);
  EXPECT_EQ(about.st_mode & 0777, 0640U);
}

TEST(ReplaceKeepingOld, WritesAFileThatDoesNotExistYet) {
  const TemporaryFolder folder;
  EXPECT_EQ(replaceKeepingOld(folder / "robot.ini", "new\n", "now"), "");
  EXPECT_EQ(readTextFile(folder / "robot.ini"), "new\n");
}

TEST(ReplaceKeepingOld, FollowsASymbolicLinkInsteadOfReplacingIt) {
  const TemporaryFolder folder;
  write(folder / "real.ini", "first\n");
  std::filesystem::create_symlink(folder / "real.ini", folder / "robot.ini");
  replaceKeepingOld(folder / "robot.ini", "second\n", "now");
  EXPECT_TRUE(std::filesystem::is_symlink(folder / "robot.ini"));
  EXPECT_EQ(readTextFile(folder / "real.ini"), "second\n");
}

TEST(ReplaceKeepingOld, LeavesNothingBehindWhereItCannotWrite) {
  const TemporaryFolder folder;
  EXPECT_THROW(replaceKeepingOld(folder / "missing/robot.ini", "new\n", "now"), std::runtime_error);
  std::filesystem::create_directory(folder / "robot.ini");  // cannot be replaced by a file
  EXPECT_THROW(replaceKeepingOld(folder / "robot.ini", "new\n", "now"), std::runtime_error);
  std::size_t entries = 0;
  for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator{folder / ""}) ++entries;
  EXPECT_EQ(entries, 1U);
}

/// After `sudo cp`: the folder is this user's, but the new file cannot be given the old one's owner.
TEST(IniEdit, AFileOfAnotherOwnerIsRefusedBeforeAnythingIsMeasured) {
  if (geteuid() != 0) GTEST_SKIP() << "only root can make a file of another owner";
  const TemporaryFolder folder;
  ASSERT_EQ(chown((folder / ".").c_str(), Unprivileged::kUser, Unprivileged::kUser), 0);
  write(folder / "robot.ini", kText);
  const Unprivileged user;
  EXPECT_THAT([&] { requireReplaceable(folder / "robot.ini"); },
              testing::ThrowsMessage<std::runtime_error>(testing::HasSubstr(kCannotWrite + (folder / "robot.ini"))));
  requireReplaceable(folder / "new.ini");
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator{folder / "."}, {}), 1) << "nothing is left beside it";
}

}  // namespace
}  // namespace darwinop::calibrate
