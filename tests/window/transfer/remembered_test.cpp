// File of recently used robots: private, atomic, robust.
#include "window/transfer/remembered.hpp"

#include <gmock/gmock.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <fstream>
#include <sstream>

#include "support/temporary_folder.hpp"

namespace darwinop {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::string textIn(const std::string& file) {
  std::ostringstream text;
  text << std::ifstream{file}.rdbuf();
  return text.str();
}

struct RememberedRobots : testing::Test {
  TemporaryFolder folder;
  std::string file = (folder / "darwinop/robots.json");
  window::RobotAddress darwin{.address = "192.168.123.1", .user = "darwin", .key = "/k", .port = 22};
  window::RobotAddress op2{.address = "op2", .user = "robotis"};
};

TEST_F(RememberedRobots, AreOrderedByUseInAPrivateFile) {
  window::RememberedFile remembered{file};
  remembered.note(darwin, "/walker");
  remembered.note(op2, "");
  remembered.note(darwin, "/soccer");
  const window::RememberedFile again{file};
  EXPECT_THAT(again.all().robots, ElementsAre(darwin, op2));
  EXPECT_THAT(again.all().controllers, ElementsAre("/soccer", "/walker"));
  EXPECT_EQ(again.error(), "");
  struct stat about {};
  ASSERT_EQ(stat(file.c_str(), &about), 0);
  EXPECT_EQ(about.st_mode & 0777U, 0600U);
  remembered.forget({.address = "192.168.123.1", .user = "darwin"});
  EXPECT_THAT(window::RememberedFile{file}.all().robots, ElementsAre(op2));
}

TEST_F(RememberedRobots, ReportAndKeepAnInvalidFile) {
  std::filesystem::create_directory((folder / "darwinop"));
  for (const char* text :
       {"{\"robots\": [", R"({"robots": [{"address": "-x", "user": "a"}]})", R"({"password": []})", "[]"}) {
    std::ofstream{file} << text;
    window::RememberedFile remembered{file};
    EXPECT_THAT(remembered.error(), HasSubstr(file + ".damaged")) << text;
    EXPECT_TRUE(remembered.all().robots.empty());
    EXPECT_EQ(textIn(file + ".damaged"), text);
    remembered.note(op2, "");
    EXPECT_THAT(window::RememberedFile{file}.all().robots, ElementsAre(op2));
  }
}

TEST_F(RememberedRobots, DoNotWaitForAPipeInPlaceOfTheFile) {
  std::filesystem::create_directory((folder / "darwinop"));
  ASSERT_EQ(mkfifo(file.c_str(), 0600), 0);
  EXPECT_THAT(window::RememberedFile{file}.error(), HasSubstr("it is a pipe; give a regular file"));
}

/// Limits the size of files of this process, like a full disk.
class FullDisk {
 public:
  explicit FullDisk(rlim_t bytes) {
    getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit small{bytes, before_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &small);
  }
  ~FullDisk() {
    setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }
  FullDisk(const FullDisk&) = delete;
  FullDisk& operator=(const FullDisk&) = delete;

 private:
  sighandler_t handler_ = std::signal(SIGXFSZ, SIG_IGN);
  rlimit before_{};
};

TEST_F(RememberedRobots, ReportAFileThatCannotBeWrittenUntilItCan) {
  window::RememberedFile remembered{file};
  remembered.note(darwin, "/walker");
  const std::string before = textIn(file);
  const std::string next = file + ".new-" + std::to_string(getpid());
  {
    const FullDisk full{before.size() / 2};
    remembered.note(op2, "/soccer");
  }
  EXPECT_THAT(remembered.error(), AllOf(HasSubstr(file), HasSubstr(std::strerror(EFBIG))));
  EXPECT_THAT(remembered.all().robots, ElementsAre(op2, darwin)) << "kept in memory while the window is open";
  EXPECT_EQ(textIn(file), before);
  EXPECT_FALSE(std::filesystem::exists(next)) << "an incomplete file is left";
  std::filesystem::create_directory(next);  // so that it cannot be created
  remembered.forget(darwin);
  EXPECT_THAT(remembered.error(), AllOf(HasSubstr(file), HasSubstr(std::strerror(EISDIR))));
  EXPECT_EQ(textIn(file), before);
  std::filesystem::remove(next);
  remembered.note(op2, "");
  EXPECT_EQ(remembered.error(), "");
  EXPECT_THAT(window::RememberedFile{file}.all().robots, ElementsAre(op2, darwin));
}

TEST_F(RememberedRobots, ReportAnInvalidFileUntilItIsReadAgain) {
  std::filesystem::create_directory((folder / "darwinop"));
  window::RememberedFile remembered{file};
  std::ofstream{file} << "[]";
  remembered.note(op2, "");
  EXPECT_THAT(remembered.error(), HasSubstr(file + ".damaged")) << "writing it does not clear the error";
  remembered.note(darwin, "");
  EXPECT_EQ(remembered.error(), "");
}

TEST_F(RememberedRobots, AreLimitedAndAnUnwritableFolderIsReported) {
  window::RememberedFile remembered{file};
  for (int i = 0; i < 30; ++i)
    remembered.note({.address = "r" + std::to_string(i), .user = "u"}, "/c" + std::to_string(i));
  EXPECT_EQ(window::RememberedFile{file}.all().robots.size(), window::RememberedFile::kMost);
  window::RememberedFile nowhere{"/proc/nowhere/robots.json"};
  nowhere.note(op2, "");
  EXPECT_THAT(nowhere.error(), AllOf(HasSubstr("/proc/nowhere/robots.json"), HasSubstr(std::strerror(ENOENT))));
  EXPECT_THAT(nowhere.all().robots, ElementsAre(op2));
}

}  // namespace
}  // namespace darwinop
