#include "supervisor/log_keeper.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <thread>

#include "support/temporary_folder.hpp"
#include "support/text_of.hpp"

namespace darwinop::supervisor {
namespace {

TEST(LogKeeper, ASmallLogIsNotChanged) {
  const TemporaryFolder folder;
  std::ofstream{folder / "log"} << "short";
  EXPECT_TRUE(bound(folder / "log", 100));
  EXPECT_EQ(textOf(folder / "log"), "short");
  EXPECT_FALSE(std::filesystem::exists(folder / "log.1"));
}

TEST(LogKeeper, AFullLogIsRotatedAndItsWriterContinues) {
  const TemporaryFolder folder;
  std::ofstream writer{folder / "log", std::ios::app};
  writer << std::string(90, 'a') << std::string(60, 'b') << std::flush;
  EXPECT_TRUE(bound(folder / "log", 100));
  EXPECT_EQ(textOf(folder / "log.1"), std::string(40, 'a') + std::string(60, 'b'));
  writer << "more" << std::flush;
  EXPECT_EQ(textOf(folder / "log"), "more");
}

TEST(LogKeeper, ALogThatCannotBeCopiedIsStillTruncated) {
  const TemporaryFolder folder;
  std::ofstream{folder / "log"} << std::string(150, 'a');
  std::filesystem::create_directory(folder / "log.1");
  EXPECT_FALSE(bound(folder / "log", 100));
  EXPECT_EQ(textOf(folder / "log"), "");
}

TEST(LogKeeper, AMissingLogIsNotAnError) {
  const TemporaryFolder folder;
  EXPECT_TRUE(bound(folder / "log", 100));
}

TEST(LogKeeper, ItsThreadRotatesEachLogAndEnds) {
  using namespace std::chrono_literals;
  constexpr auto kFull = static_cast<std::size_t>(kLogBytes);
  const TemporaryFolder folder;
  for (const char* const name : {"one", "two"}) std::ofstream{folder / name} << std::string(kFull, 'a');
  {
    const LogKeeper keeper{{folder / "one", folder / "missing", folder / "two"}};
    for (int i = 0; i < 10'000 && std::filesystem::file_size(folder / "two") > 0; ++i) std::this_thread::sleep_for(1ms);
  }
  for (const char* const name : {"one", "two"}) {
    EXPECT_EQ(textOf(folder / name), "") << name;
    EXPECT_EQ(textOf(folder / name + ".1").size(), kFull) << name;
  }
}

}  // namespace
}  // namespace darwinop::supervisor
