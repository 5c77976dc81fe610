// Groups are found in the file, without the C library's plug-ins.
#include "runtime/groups.hpp"

#include <gmock/gmock.h>

#include <fstream>

#include "support/temporary_folder.hpp"

namespace darwinop::runtime {
namespace {

using ::testing::Optional;

TEST(Groups, NamesAndNumbersAreFoundAndAStrangeOneIsAbsent) {
  const TemporaryFolder folder;
  const std::string file = folder / "group";
  std::ofstream{file} << "root:x:0:\n# a comment\ndialout:x:20:darwin,guest\nstudents:*:1005:\n";
  EXPECT_THAT(groupId("dialout", file), Optional(gid_t{20}));
  EXPECT_THAT(groupId("students", file), Optional(gid_t{1005}));
  EXPECT_EQ(groupId("nobody-like-this", file), std::nullopt);
  EXPECT_EQ(groupName(20, file), "dialout");
  EXPECT_EQ(groupName(4711, file), "4711");
}

TEST(Groups, WithoutTheFileNoGroupIsFound) {
  EXPECT_EQ(groupId("root", "/nonexistent/group"), std::nullopt);
  EXPECT_EQ(groupName(0, "/nonexistent/group"), "0");
}

}  // namespace
}  // namespace darwinop::runtime
