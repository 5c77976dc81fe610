// Child processes: words, environment, descriptors, errors, end.
#include "hal/process/child_process.hpp"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <system_error>

#include "support/temporary_folder.hpp"
#include "support/text_of.hpp"

namespace darwinop::process {
namespace {

using namespace std::chrono_literals;
using testing::AllOf;
using testing::EndsWith;
using testing::HasSubstr;
using testing::StartsWith;

std::string readAll(int descriptor) {
  std::string text;
  char part[256];
  for (ssize_t count = 0; (count = read(descriptor, part, sizeof part)) > 0;)
    text.append(part, static_cast<std::size_t>(count));
  return text;
}

Start shell(const std::string& script, std::vector<Stream> streams = {}) {
  return {.command = {"/bin/sh", "-c", script}, .streams = std::move(streams)};
}

/// Standard output of a shell script that was started so.
std::string outputOf(Start start) {
  if (start.streams.empty()) start.streams = {{}, Stream::pipe()};
  ChildProcess child{start};
  std::string text = readAll(child.stream(1));
  EXPECT_TRUE(child.wait().isNormal());
  return text;
}

TEST(ChildProcess, GetsItsWordsAsTheyAre) {
  Start start = shell("printf '[%s]' \"$0\" \"$@\"");
  start.command.insert(start.command.end(), {"a b", "", "$HOME", "'\"`;"});
  EXPECT_EQ(outputOf(start), "[a b][][$HOME]['\"`;]");
}

TEST(ChildProcess, IsFoundInPathOnlyWithoutASlash) {
  EXPECT_EQ(outputOf({.command = {"echo", "found"}}), "found\n");
  EXPECT_EQ(findProgram("./echo"), "./echo");
  EXPECT_EQ(findProgram("no-program-has-this-name"), "");
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder / "sh");  // executable, but no file
  setenv("PATH", ((folder / ":") + getenv("PATH")).c_str(), 1);
  EXPECT_THAT(findProgram("sh"), EndsWith("bin/sh"));
}

TEST(ChildProcess, ThatCannotBeExecutedThrowsTheReason) {
  for (const auto& [program, error] : {std::pair{"/nonexistent", ENOENT}, {"/etc/passwd", EACCES}, {"nothing", ENOENT}})
    try {
      const ChildProcess child{{.command = {program}, .closes_others = true}};
      FAIL() << program;
    } catch (const std::system_error& thrown) {
      EXPECT_EQ(thrown.code().value(), error);
      EXPECT_THAT(thrown.what(), StartsWith(std::string{kCannotStart} + program + ": "));
    }
  EXPECT_EQ(waitpid(-1, nullptr, WNOHANG), -1) << "a zombie is left";
}

TEST(ChildProcess, WithAnErrorPrefixEndsWithAMessageAndTheCodeOfAShell) {
  for (const auto& [program, code] : {std::pair{"/nonexistent", 127}, {"/etc/passwd", 126}}) {
    ChildProcess child{{.command = {program}, .streams = {{}, {}, Stream::pipe()}, .error_prefix = "test: "}};
    EXPECT_THAT(readAll(child.stream(2)), AllOf(StartsWith("test: "), HasSubstr(std::string{" "} + program + ": ")));
    EXPECT_EQ(child.wait().code, code);
  }
}

TEST(ChildProcess, HasOurEnvironmentWithReplacementsAndWithoutAName) {
  setenv("PROCESS_TEST_KEPT", "kept", 1);
  setenv("PROCESS_TEST_REPLACED", "old", 1);
  setenv("PROCESS_TEST_LEFT", "left", 1);
  setenv("PROCESS_TEST_LEFT_OUT", "kept", 1);
  std::string secret = "PROCESS_TEST_SECRET=s";
  const std::string all = outputOf({.command = {"env"},
                                    .environment = {"PROCESS_TEST_REPLACED=new", "PROCESS_TEST_ADDED=a=b"},
                                    .without_variable = "PROCESS_TEST_LEFT",
                                    .secret = secret.data()});
  for (const char* line : {"KEPT=kept", "REPLACED=new", "ADDED=a=b", "LEFT_OUT=kept", "SECRET=s"})
    EXPECT_THAT(all, HasSubstr(std::string{"PROCESS_TEST_"} + line + "\n"));
  EXPECT_THAT(all, Not(HasSubstr("old")));
  EXPECT_THAT(all, Not(HasSubstr("PROCESS_TEST_LEFT=")));
}

TEST(ChildProcess, RunsInItsFolder) {
  Start start = shell("pwd");
  start.folder = "/";
  EXPECT_EQ(outputOf(start), "/\n");
}

TEST(ChildProcess, ReadsAndWritesPipesUntilTheyAreClosed) {
  ChildProcess child{
      shell("cat; echo error >&2; echo third >&3", {Stream::pipe(), Stream::pipe(), Stream::pipe(), Stream::pipe()})};
  ASSERT_EQ(write(child.stream(0), "input", 5), 5);
  EXPECT_FALSE(child.waitFor(50ms)) << "it reads on";
  child.closeStream(0);
  EXPECT_EQ(readAll(child.stream(1)), "input");
  EXPECT_EQ(readAll(child.stream(2)), "error\n");
  EXPECT_EQ(readAll(child.stream(3)), "third\n");
  EXPECT_TRUE(child.wait().isNormal());
}

TEST(ChildProcess, HasCopiesOfOurDescriptorsAndNothing) {
  const TemporaryFolder folder;
  const int out = open((folder / "out").c_str(), O_CREAT | O_WRONLY | O_CLOEXEC, 0600);
  // 3 is a copy of our 2, not of its own, which is another file.
  ChildProcess child{shell("cat; echo one; echo two >&2; echo of the test >&3",
                           {Stream::nothing(), Stream::copyOf(out), Stream::copyOf(out), Stream::copyOf(2)})};
  EXPECT_TRUE(child.wait().isNormal());
  close(out);
  EXPECT_EQ(textOf(folder / "out"), "one\ntwo\n");
}

TEST(ChildProcess, AppendsToAFileButNotThroughALink) {
  const TemporaryFolder folder;
  for (const char* text : {"one", "two"}) {
    ChildProcess child{shell(std::string{"echo "} + text, {{}, Stream::appendedTo(folder / "log")})};
    EXPECT_TRUE(child.wait().isNormal());
  }
  EXPECT_EQ(textOf(folder / "log"), "one\ntwo\n");
  std::filesystem::create_symlink("log", folder / "link");
  Start start = shell("echo three", {{}, Stream::appendedTo(folder / "link"), Stream::pipe()});
  start.error_prefix = "";
  ChildProcess child{start};
  EXPECT_TRUE(child.wait().isNormal());
  EXPECT_EQ(textOf(folder / "log"), "one\ntwo\n");
}

TEST(ChildProcess, InheritsNoOtherDescriptorIfItClosesThem) {
  const int open_here = fcntl(0, F_DUPFD, 20);  // without O_CLOEXEC
  const std::string here = std::to_string(open_here) + " ";
  Start start = shell("for n in 0 1 2 3 " + here + "; do [ -e /proc/$$/fd/$n ] && printf '%s ' $n; done; true");
  EXPECT_THAT(outputOf(start), EndsWith(here));
  start.closes_others = true;
  EXPECT_EQ(outputOf(start), "0 1 2 ");
  start.streams = {{}, Stream::pipe(), {}, Stream::nothing()};
  EXPECT_EQ(outputOf(start), "0 1 2 3 ");
  close(open_here);
}

TEST(ChildProcess, EndsWithACodeOrASignal) {
  ChildProcess failed{shell("exit 3")};
  EXPECT_THAT(describe(failed.wait()), EndsWith(" 3"));
  EXPECT_FALSE(failed.wait().by_signal);
  EXPECT_EQ(failed.wait().shellStatus(), 3);
  ChildProcess killed{shell("kill -SEGV $$")};
  EXPECT_THAT(describe(killed.wait()), EndsWith(std::string{" 11 ("} + strsignal(SIGSEGV) + ")"));
  EXPECT_TRUE(killed.wait().by_signal);
  EXPECT_EQ(killed.wait().shellStatus(), 139);
}

TEST(ChildProcess, ReapedElsewhereCountsAsKilled) {
  ChildProcess child{shell("exit 0")};
  ASSERT_EQ(waitpid(child.pid(), nullptr, 0), child.pid());
  EXPECT_EQ(child.ended()->code, SIGKILL);
}

TEST(ChildProcess, IsKilledAfterItsGrace) {
  ChildProcess stubborn{shell("trap '' TERM; echo; while :; do sleep 0.01; done", {{}, Stream::pipe()})};
  char byte = 0;
  ASSERT_EQ(read(stubborn.stream(1), &byte, 1), 1);
  stubborn.signal(SIGTERM);
  EXPECT_EQ(stubborn.waitOrKill(50ms).code, SIGKILL);
  ChildProcess tidy{shell("trap 'exit 5' TERM; echo; while :; do sleep 0.01; done", {{}, Stream::pipe()})};
  ASSERT_EQ(read(tidy.stream(1), &byte, 1), 1);
  tidy.signal(SIGTERM);
  EXPECT_EQ(tidy.waitOrKill(20s).code, 5);
}

TEST(ChildProcess, RunsOnWhenItIsDetached) {
  const TemporaryFolder folder;
  pid_t pid = 0;
  {
    ChildProcess child{shell("read line; echo done >" + (folder / "out"), {Stream::copyOf(0)})};
    pid = child.pid();
    child.detach();
  }
  int status = -1;
  EXPECT_EQ(waitpid(pid, &status, 0), pid);
  EXPECT_EQ(status, 0);
}

}  // namespace
}  // namespace darwinop::process
