#include "supervisor/status.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "support/temporary_folder.hpp"

namespace darwinop::supervisor {
namespace {

TEST(Status, WhatIsWrittenIsRead) {
  const TemporaryFolder folder;
  Status status;
  status.home = "/opt/dar win";
  status.state = "two\nlines";
  status.runtime_pid = 12;
  status.crashes = 2;
  status.orders = 7;
  status.left = "a sentence";
  status.controller_ended = true;
  ASSERT_TRUE(writeStatus(status, folder / "status"));
  status.state = "two lines";
  EXPECT_EQ(readStatus(folder / "status"), status);
}

TEST(Status, AMissingOrIncompleteFileIsEmpty) {
  const TemporaryFolder folder;
  EXPECT_EQ(readStatus(folder / "status"), std::nullopt);
  std::ofstream{folder / "status"} << "home /opt\nstate x\n";
  EXPECT_EQ(readStatus(folder / "status"), std::nullopt);
}

TEST(Status, NoForeignThingBesideItPreventsIt) {
  const TemporaryFolder folder;
  std::filesystem::create_directories(folder / "status.new/full");  // the name of earlier versions
  EXPECT_TRUE(writeStatus(Status{}, folder / "status"));
  EXPECT_EQ(readStatus(folder / "status"), Status{});
}

TEST(Status, AMissingFolderReturnsFalse) {
  const TemporaryFolder folder;
  EXPECT_FALSE(writeStatus(Status{}, folder / "nowhere/status"));
}

}  // namespace
}  // namespace darwinop::supervisor
