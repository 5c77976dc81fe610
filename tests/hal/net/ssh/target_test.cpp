// Which robots a program of the PC logs in to.
#include "hal/net/ssh/target.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace darwinop::remote {
namespace {

TEST(SshTarget, IsARobotWithAUser) {
  EXPECT_EQ(sshTarget("tcp://darwin@192.168.123.1"), "darwin@192.168.123.1");
  EXPECT_EQ(sshTarget("tcp://darwin@[fe80::1]"), "darwin@fe80::1");
  EXPECT_FALSE(sshTarget("tcp://192.168.123.1:5023"));
  EXPECT_FALSE(sshTarget("twin"));
}

TEST(SshTarget, HasNoPortOfTheServer) {
  EXPECT_THROW((void)sshTarget("tcp://darwin@192.168.123.1:5023"), std::runtime_error);
}

}  // namespace
}  // namespace darwinop::remote
