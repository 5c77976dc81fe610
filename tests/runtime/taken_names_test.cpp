// Another user takes a name of the runtime in a sticky folder such as /dev/shm beforehand. Nothing there is followed,
// waited for or believed, a release is not hidden, and the messages name the path.
#include <gmock/gmock.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "other_user.hpp"
#include "runtime/exchange.hpp"
#include "runtime/exchange_reader.hpp"
#include "runtime/file_lock.hpp"
#include "runtime/messages.hpp"
#include "runtime/robot_notes.hpp"
#include "safety/fault_book.hpp"
#include "support/temporary_folder.hpp"
#include "support/text_of.hpp"

namespace darwinop::runtime {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

/// What is put at `path`; `precious` is a file of the victim. False: not possible here.
struct Thing {
  const char* name;
  bool (*put)(const std::string& path, const std::string& precious);
};

const Thing kThings[] = {
    {"Link",
     [](const std::string& path, const std::string& precious) { return symlink(precious.c_str(), path.c_str()) == 0; }},
    {"DanglingLink",
     [](const std::string& path, const std::string&) { return symlink("/no/such/file", path.c_str()) == 0; }},
    {"Fifo", [](const std::string& path, const std::string&) { return mkfifo(path.c_str(), 0666) == 0; }},
    {"Folder", [](const std::string& path, const std::string&) { return mkdir(path.c_str(), 0777) == 0; }},
    {"FullFolder", [](const std::string& path, const std::string&) { return fs::create_directories(path + "/a/b"); }},
    {"HardLink",
     [](const std::string& path, const std::string& precious) { return link(precious.c_str(), path.c_str()) == 0; }},
    {"WorldWritable",
     [](const std::string& path, const std::string&) {
       std::ofstream{path} << "0\n";
       return chmod(path.c_str(), 0666) == 0;
     }},
    {"OfAnotherUser",
     [](const std::string& path, const std::string&) { return asNobody([&] { std::ofstream{path} << "0\n"; }); }},
};

class TakenName : public testing::TestWithParam<Thing> {
 protected:
  void SetUp() override {
    ASSERT_EQ(chmod((folder_ / "").c_str(), 01777), 0);
    std::ofstream{precious_} << "0\n";
  }
  void TearDown() override { EXPECT_EQ(textOf(precious_), "0\n"); }
  /// False: only root can become another user.
  bool take(const std::string& path) { return GetParam().put(path, precious_); }

  template <class Action>
  static std::string refusal(Action action) {
    try {
      action();
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "accepted";
  }

  TemporaryFolder folder_;
  std::string precious_{folder_ / "precious"};
  RuntimeFiles files_{folder_ / "runtime"};
};
INSTANTIATE_TEST_SUITE_P(By, TakenName, testing::ValuesIn(kThings), [](const auto& by) { return by.param.name; });

TEST_P(TakenName, OfALockIsRefusedAndHasNoHolder) {
  for (const std::string& path : {files_.loop_lock, files_.drive_lock}) {
    if (!take(path)) GTEST_SKIP() << "only root can become another user";
    EXPECT_THAT(refusal([&] { (void)FileLock::tryTake(path); }), HasSubstr(path));
    EXPECT_EQ(FileLock::holder(path), 0);
    EXPECT_THAT(refusal([&] { (void)FileLock::provenHolder(path); }), HasSubstr(path));
  }
}

TEST_P(TakenName, OfTheExchangeIsNotReadAndANewOneReplacesItOrSaysWhyNot) {
  if (!take(files_.exchange)) GTEST_SKIP() << "only root can become another user";
  EXPECT_FALSE(ExchangeReader::open(files_.exchange).has_value());
  EXPECT_THAT(refusal([&] { (void)Exchange::attach(files_.exchange, Exchange::Access::kRead); }),
              HasSubstr(files_.exchange));
  const std::string why = refusal([&] { (void)Exchange::create(files_.exchange); });
  if (fs::is_directory(fs::symlink_status(files_.exchange)))  // it may be a mistaken --name
    EXPECT_THAT(why, HasSubstr(" rm " + files_.exchange));
  else
    EXPECT_TRUE(ExchangeReader::open(files_.exchange).has_value()) << why;
}

TEST_P(TakenName, OfTheCommandsIsNotWritten) {
  const Exchange host = Exchange::create(files_.exchange);
  ASSERT_EQ(unlink(files_.commands.c_str()), 0);
  if (!take(files_.commands)) GTEST_SKIP() << "only root can become another user";
  EXPECT_THAT(refusal([&] { (void)Exchange::attach(files_.exchange); }), HasSubstr(files_.commands));
}

TEST_P(TakenName, OfTheRecordOfAReleaseCountsAsAReleaseWhichNobodyCanHideAgain) {
  if (!take(files_.released)) GTEST_SKIP() << "only root can become another user";
  {
    const RobotNotes notes{files_};
    EXPECT_TRUE(notes.released());
    EXPECT_TRUE(notes.kept());
    EXPECT_THAT(notes.warning(), HasSubstr(files_.released + messages::kMarkerOfOthers));
  }
  const RobotNotes next{files_};
  EXPECT_TRUE(next.released()) << "recorded, even if the thing is removed later";
  EXPECT_EQ(next.warning(), "");
  RobotNotes::forget(files_);
  EXPECT_FALSE(RobotNotes{files_}.released()) << "a person has acted";
}

TEST_P(TakenName, OfTheRecordOfAHeldRobotCountsAsHeldAndReleased) {
  if (!take(files_.held)) GTEST_SKIP() << "only root can become another user";
  const RobotNotes notes{files_};
  EXPECT_TRUE(notes.held());
  EXPECT_TRUE(notes.released());
  EXPECT_THAT(notes.warning(), HasSubstr(files_.held + messages::kMarkerOfOthers));
}

TEST_P(TakenName, OfARecordIsGivenUpToTheNextPersonWhoActs) {
  if (!take(files_.released)) GTEST_SKIP() << "only root can become another user";
  RobotNotes::forget(files_);
  EXPECT_FALSE(RobotNotes{files_}.released());
}

/// The name is taken between two cycles: the daemon's own file was removed by a slip.
TEST_P(TakenName, DuringARunDoesNotStallTheDaemonAndItsRecordComesBack) {
  RobotNotes notes{files_};
  ASSERT_EQ(unlink(files_.released.c_str()), 0);
  if (!take(files_.released)) GTEST_SKIP() << "only root can become another user";
  Sensors seen;
  seen.cycle = 1;
  seen.safety.state = State::kLimp;
  seen.safety.active.set(safety::rowIndex(Fault::kReleasedByOperator));
  notes.update(seen);
  const RobotNotes next{files_};
  EXPECT_TRUE(next.released());
  EXPECT_EQ(next.warning(), "");
}

TEST(WorldWritable, ExchangeAndCommandsOfARunningRuntimeAreRefusedByAllAndANewRuntimeReplacesThem) {
  const TemporaryFolder folder;
  const RuntimeFiles files{folder / "runtime"};
  for (const std::string& path : {files.exchange, files.commands}) {
    const Exchange host = Exchange::create(files.exchange);
    ASSERT_NO_THROW((void)Exchange::attach(files.exchange));
    ASSERT_EQ(chmod(path.c_str(), 0666), 0);
    try {
      (void)Exchange::attach(files.exchange);
      FAIL() << "accepted";
    } catch (const std::runtime_error& error) {
      EXPECT_THAT(error.what(), testing::AllOf(HasSubstr(path), HasSubstr(messages::kEveryUserMayWrite)));
    }
    EXPECT_EQ(ExchangeReader::open(files.exchange).has_value(), path != files.exchange);
  }
  const Exchange next = Exchange::create(files.exchange);
  for (const std::string& path : {files.exchange, files.commands}) {
    struct stat status {};
    ASSERT_EQ(stat(path.c_str(), &status), 0);
    EXPECT_EQ(status.st_mode & S_IWOTH, 0U) << path;
  }
  EXPECT_NO_THROW((void)Exchange::attach(files.exchange));
}

TEST(WorldWritable, FilesOfARuntimeNeverAreWhateverTheUmask) {
  const TemporaryFolder folder;
  const RuntimeFiles files{folder / "runtime"};
  const mode_t before = umask(0);
  const Exchange host = Exchange::create(files.exchange);
  const auto lock = FileLock::tryTake(files.loop_lock);
  const RobotNotes notes{files};
  umask(before);
  for (const auto& entry : fs::directory_iterator{folder / ""})
    EXPECT_EQ(entry.status().permissions() & fs::perms::others_write, fs::perms::none) << entry.path();
}

}  // namespace
}  // namespace darwinop::runtime
