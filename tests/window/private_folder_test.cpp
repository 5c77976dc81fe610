// Temporary folders of windows and their removal.
#include "window/private_folder.hpp"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <optional>

#include "support/temporary_folder.hpp"

namespace darwinop::window {
namespace {

namespace fs = std::filesystem;

class WindowFolder : public testing::Test {
 protected:
  [[nodiscard]] std::string parent() const { return folder_ / ""; }
  [[nodiscard]] int folders() const {
    return static_cast<int>(std::distance(fs::directory_iterator{parent()}, fs::directory_iterator{}));
  }
  /// A window that is killed before it removes its folder.
  void leaveOne() const {
    const pid_t killed = fork();
    if (killed == 0) {
      const PrivateFolder own{parent()};
      std::ofstream{own.path() + "/runtime"} << "a file";
      (void)kill(getpid(), SIGKILL);
    }
    ASSERT_EQ(waitpid(killed, nullptr, 0), killed);
  }

  TemporaryFolder folder_;
};

TEST_F(WindowFolder, IsRemovedWithItsWindow) {
  std::optional<PrivateFolder> own{std::in_place, parent()};
  EXPECT_TRUE(fs::is_directory(own->path()));
  own.reset();
  EXPECT_EQ(folders(), 0);
}

TEST_F(WindowFolder, OfAKilledWindowIsRemovedByTheNext) {
  leaveOne();
  leaveOne();
  EXPECT_EQ(folders(), 1) << "the second window has removed that of the first";
  const PrivateFolder next{parent()};
  EXPECT_EQ(folders(), 1);
  EXPECT_TRUE(fs::exists(next.path()));
}

TEST_F(WindowFolder, OfARunningWindowAndOfOthersIsKept) {
  const PrivateFolder other{parent()};
  const std::string elsewhere = folder_ / "important";
  fs::create_directory(elsewhere);
  fs::create_directory(folder_ / "darwinop-window-3F8a2z");                           // not a pid
  fs::create_directory_symlink(elsewhere, folder_ / "darwinop-window-4194305-link");  // above every pid
  const PrivateFolder next{parent()};
  EXPECT_EQ(folders(), 5);
  EXPECT_TRUE(fs::exists(other.path()));
}

}  // namespace
}  // namespace darwinop::window
