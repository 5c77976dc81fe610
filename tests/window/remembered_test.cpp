// The file of remembered robots: whole, private, and never lost.
#include "window/remembered.hpp"

#include <gmock/gmock.h>
#include <sys/stat.h>

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
