#include "supervisor/status.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>
#include <fstream>

#include "runtime/environment.hpp"
#include "supervisor/supervisor.hpp"
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
  status.at_rest = true;
  status.stopping = true;
  status.stays_ended = true;
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

TEST(Status, AForeignThingInItsPlaceIsNotReadAndIsReplaced) {
  const TemporaryFolder folder;
  const std::string path = folder / "status";
  std::filesystem::create_directories(folder / "status.new/full");  // the name of earlier versions
  const auto expect_replaced = [&] {
    EXPECT_EQ(readStatus(path), std::nullopt);
    EXPECT_TRUE(writeStatus(Status{}, path));
    EXPECT_EQ(readStatus(path), Status{});
    std::filesystem::remove(path);
  };
  std::filesystem::create_directories(folder / "status/full");
  expect_replaced();
  ASSERT_EQ(mkfifo(path.c_str(), 0666), 0);
  expect_replaced();
  ASSERT_TRUE(writeStatus(Status{}, folder / "other"));
  std::filesystem::create_symlink(folder / "other", path);
  expect_replaced();
  std::filesystem::create_hard_link(folder / "other", path);
  expect_replaced();
  ASSERT_TRUE(writeStatus(Status{}, path));
  ASSERT_EQ(chmod(path.c_str(), 0666), 0);
  expect_replaced();
}

TEST(Status, AMissingFolderReturnsFalse) {
  const TemporaryFolder folder;
  EXPECT_FALSE(writeStatus(Status{}, folder / "nowhere/status"));
}

/// A supervisor that dies before it has recorded anything must not hide how the one before it ended.
TEST(Status, ARecordThatDoesNotClaimRestStaysUntilTheNextSupervisorReplacesIt) {
  const TemporaryFolder folder;
  const runtime::Environment name{"DARWINOP_RUNTIME_NAME", folder / "runtime"};
  const std::string path = SupervisorFiles{runtime::RuntimeFiles{}}.status;
  Status last;
  for (const bool at_rest : {false, true}) {
    last.at_rest = at_rest;
    ASSERT_TRUE(writeStatus(last, path));
    { const Supervisor killed{{.home = folder / "", .runtime_program = ""}}; }
    EXPECT_EQ(readStatus(path).has_value(), !at_rest);
  }
}

}  // namespace
}  // namespace darwinop::supervisor
