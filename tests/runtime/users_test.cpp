// Who a user is, and becoming one for good.
#include "runtime/users.hpp"

#include <gmock/gmock.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>

#include "support/temporary_folder.hpp"

namespace darwinop::runtime {
namespace {

using testing::ElementsAre;

struct Users : ::testing::Test {
  TemporaryFolder folder;
  UserFiles files{folder / "passwd", folder / "group"};
  void SetUp() override {
    std::ofstream{files.passwd} << "root:x:0:0:root:/root:/bin/sh\nno-user-line\n"
                                   "darwinop:*:998:997:controllers:/opt/darwinop:/bin/false\n";
    std::ofstream{files.group} << "root:x:0:\nvideo:x:44:darwin,darwinop\naudio:x:29:darwinop2\n"
                                  "darwinop:x:997:darwinop\ninput:x:104:darwinop\n";
  }
};

TEST_F(Users, AnAccountHasItsOwnGroupFirstAndEachOtherOnce) {
  const auto account = findAccount("darwinop", files);
  ASSERT_TRUE(account);
  EXPECT_EQ(account->uid, 998U);
  EXPECT_EQ(account->gid, 997U);
  EXPECT_EQ(account->home, "/opt/darwinop");
  EXPECT_THAT(account->groups, ElementsAre(997U, 44U, 104U));
}

TEST_F(Users, WhoIsNotThereIsNoAccount) {
  EXPECT_FALSE(findAccount("darwin", files));
  EXPECT_FALSE(findAccount("darwinop", {"/nonexistent/passwd", files.group}));
}

TEST_F(Users, ThereIsNoWayBackToRoot) {
  if (geteuid() != 0) GTEST_SKIP() << "only root can become another user";
  const pid_t child = fork();
  if (child == 0) {
    becomeUser(*findAccount("darwinop", files));
    gid_t groups[8];
    const bool gone = getuid() == 998 && getegid() == 997 && getgroups(8, groups) == 3 && setuid(0) != 0 &&
                      setgid(0) != 0 && access("/etc/shadow", R_OK) != 0;
    _exit(gone && std::string{getenv("HOME")} == "/opt/darwinop" && std::string{getenv("USER")} == "darwinop" ? 0 : 1);
  }
  int status = 0;
  waitpid(child, &status, 0);
  EXPECT_EQ(status, 0);
}

}  // namespace
}  // namespace darwinop::runtime
