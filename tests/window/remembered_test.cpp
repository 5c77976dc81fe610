// The file of remembered robots: whole, private, and never lost.
#include "window/remembered.hpp"

#include <gmock/gmock.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
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

TEST_F(RememberedRobots, TheLastOneUsedComesFirstAndNobodyElseMayRead) {
  window::RememberedFile remembered{file};
  remembered.note(darwin, "/walker");
  remembered.note(op2, "");
  remembered.note(darwin, "/soccer");
  const window::RememberedFile again{file};
  EXPECT_THAT(again.all().robots, ElementsAre(darwin, op2));
  EXPECT_THAT(again.all().controllers, ElementsAre("/soccer", "/walker"));
  EXPECT_EQ(again.trouble(), "");
  struct stat about {};
  ASSERT_EQ(stat(file.c_str(), &about), 0);
  EXPECT_EQ(about.st_mode & 0777U, 0600U);
  remembered.forget({.address = "192.168.123.1", .user = "darwin"});
  EXPECT_THAT(window::RememberedFile{file}.all().robots, ElementsAre(op2));
}

TEST_F(RememberedRobots, ADamagedFileIsSaidAndKeptAside) {
  std::filesystem::create_directory((folder / "darwinop"));
  for (const char* text :
       {"{\"robots\": [", R"({"robots": [{"address": "-x", "user": "a"}]})", R"({"password": []})", "[]"}) {
    std::ofstream{file} << text;
    window::RememberedFile remembered{file};
    EXPECT_THAT(remembered.trouble(), HasSubstr("could not be understood")) << text;
    EXPECT_TRUE(remembered.all().robots.empty());
    EXPECT_EQ(textIn(file + ".damaged"), text);
    remembered.note(op2, "");
    EXPECT_THAT(window::RememberedFile{file}.all().robots, ElementsAre(op2));
  }
}

/// No file of this process may grow beyond it, as on a full disk.
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

TEST_F(RememberedRobots, AFileThatCannotBeWrittenStaysWholeIsSaidAndNoMoreOnceItCan) {
  window::RememberedFile remembered{file};
  remembered.note(darwin, "/walker");
  const std::string before = textIn(file);
  const std::string next = file + ".new-" + std::to_string(getpid());
  {
    const FullDisk full{before.size() / 2};
    remembered.note(op2, "/soccer");
  }
  EXPECT_THAT(remembered.trouble(), AllOf(HasSubstr("not remembered"), HasSubstr("File too large")));
  EXPECT_THAT(remembered.all().robots, ElementsAre(op2, darwin)) << "for as long as the window is open";
  EXPECT_EQ(textIn(file), before);
  EXPECT_FALSE(std::filesystem::exists(next)) << "half a file lies about";
  std::filesystem::create_directory(next);  // nor can it be begun
  remembered.forget(darwin);
  EXPECT_THAT(remembered.trouble(), HasSubstr("not remembered"));
  EXPECT_EQ(textIn(file), before);
  std::filesystem::remove(next);
  remembered.note(op2, "");
  EXPECT_EQ(remembered.trouble(), "");
  EXPECT_THAT(window::RememberedFile{file}.all().robots, ElementsAre(op2, darwin));
}

TEST_F(RememberedRobots, ThatAFileWasDamagedIsSaidUntilItWasReadAgain) {
  std::filesystem::create_directory((folder / "darwinop"));
  window::RememberedFile remembered{file};
  std::ofstream{file} << "[]";
  remembered.note(op2, "");
  EXPECT_THAT(remembered.trouble(), HasSubstr("could not be understood")) << "it can be written, and that is no excuse";
  remembered.note(darwin, "");
  EXPECT_EQ(remembered.trouble(), "");
}

TEST_F(RememberedRobots, AreFewAndAPlaceThatCannotBeWrittenToIsSaid) {
  window::RememberedFile remembered{file};
  for (int i = 0; i < 30; ++i)
    remembered.note({.address = "r" + std::to_string(i), .user = "u"}, "/c" + std::to_string(i));
  EXPECT_EQ(window::RememberedFile{file}.all().robots.size(), window::RememberedFile::kMost);
  window::RememberedFile nowhere{"/proc/nowhere/robots.json"};
  nowhere.note(op2, "");
  EXPECT_THAT(nowhere.trouble(), HasSubstr("not remembered"));
  EXPECT_THAT(nowhere.all().robots, ElementsAre(op2));
}

}  // namespace
}  // namespace darwinop
