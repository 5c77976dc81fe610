// Motion manager: selection of the motion file and of the built-in pages.
#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>

#include "motion_rig.hpp"

namespace darwinop::webots_api {
namespace {

using managers::DARwInOPMotionManager;
using testing::HasSubstr;
using testing::internal::CaptureStderr;
using testing::internal::GetCapturedStderr;

using MotionFiles = MotionManagerTest;

/// With another data directory.
struct Elsewhere : DARwInOPMotionManager {
  Elsewhere(webots::Robot* robot, const std::string& file, const std::string& directory)
      : DARwInOPMotionManager(robot, file, directory) {}
};

TEST_F(MotionFiles, WithoutACustomFileUsesTheDataDirectory) {
  std::filesystem::copy(path_, folder_ / "motion_4096.bin");
  CaptureStderr();
  EXPECT_TRUE((Elsewhere{&robot(), path_, "/nowhere/"}.isCorrectlyInitialized()));
  Elsewhere manager{&robot(), "", folder_ / ""};
  EXPECT_TRUE(manager.isCorrectlyInitialized());
  EXPECT_EQ(GetCapturedStderr(), "");
  manager.playPage(2);
  EXPECT_EQ(fake.published.size(), 8u) << "16 ticks of 8 ms";
}

TEST_F(MotionFiles, WithoutAnyFilePlaysBuiltInPagesAndWarnsOnce) {
  CaptureStderr();
  Elsewhere missing{&robot(), "", folder_ / ""}, again{&robot(), "", folder_ / ""};
  EXPECT_EQ(GetCapturedStderr(), "darwinop: MotionManager: cannot find " + (folder_ / "motion_4096.bin") +
                                     ": the built-in pages are played (darwinop motion list own)\n");
  EXPECT_TRUE(missing.isCorrectlyInitialized());
  missing.playPage(9, false);
  EXPECT_TRUE(missing.isMotionPlaying());
  missing.step(1000);
  EXPECT_EQ(robot().step(16), 0);
  EXPECT_NE(ticksOf(Joint::kLegLowerR), 2000) << "page 9 stands up";
}

TEST_F(MotionFiles, BuiltInPagesAreSelectedByName) {
  std::filesystem::copy(path_, folder_ / "motion_4096.bin");
  CaptureStderr();
  Elsewhere manager{&robot(), "own", folder_ / ""};
  manager.playPage(9, false);
  EXPECT_TRUE(manager.isMotionPlaying()) << "the file in the directory has no page 9";
  EXPECT_EQ(GetCapturedStderr(), "");
}

TEST_F(MotionFiles, BuiltInPagesNeverReplaceAFile) {
  CaptureStderr();
  DARwInOPMotionManager missing{&robot(), folder_ / "none.bin"};
  EXPECT_FALSE(missing.isCorrectlyInitialized());
  EXPECT_EQ(GetCapturedStderr(),
            "darwinop: MotionManager: " + (folder_ / "none.bin") + ": cannot open the file; no page will be played\n");
  std::ofstream{folder_ / "motion_4096.bin"} << "darwinop motion 1\n[page 1]\nNeck = x\n";
  CaptureStderr();
  Elsewhere broken{&robot(), "", folder_ / ""};
  EXPECT_FALSE(broken.isCorrectlyInitialized());
  EXPECT_THAT(GetCapturedStderr(), HasSubstr("motion_4096.bin, line 3, page 1: Neck, step 1: 'x' is not an angle"));
  std::filesystem::remove(folder_ / "motion_4096.bin");
  std::filesystem::create_symlink("/nowhere/at/all", folder_ / "motion_4096.bin");
  forgetWarnings();
  CaptureStderr();
  EXPECT_FALSE((Elsewhere{&robot(), "", folder_ / ""}.isCorrectlyInitialized())) << "a dangling symbolic link";
  EXPECT_THAT(GetCapturedStderr(), HasSubstr("cannot open the file; no page will be played"));
}

TEST_F(MotionFiles, ACustomFileMayBeText) {
  std::ofstream{folder_ / "mine.txt"} << "darwinop motion 1\n[page 3]\ntime = 1\nNeck = 4\n";
  DARwInOPMotionManager manager{&robot(), folder_ / "mine.txt"};
  EXPECT_TRUE(manager.isCorrectlyInitialized());
  manager.playPage(3);
  EXPECT_EQ(ticksOf(Joint::kNeck), 2048 + 46) << "4 degrees";
}

}  // namespace
}  // namespace darwinop::webots_api
