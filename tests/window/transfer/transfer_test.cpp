// Transfer channel with a shell script as installer.
#include "window/transfer/transfer.hpp"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <sys/stat.h>

#include <chrono>
#include <fstream>
#include <nlohmann/json.hpp>
#include <thread>

#include "support/temporary_folder.hpp"
#include "window/messages.hpp"

namespace darwinop {
namespace {

using namespace std::chrono_literals;
using nlohmann::json;
using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

constexpr const char* kStatus = R"({"start": {"action": "status", "robot": {"address": "r", "user": "darwin"}}})";

/// A page that requests more lines after each message.
struct TransferPage final : web::Channel {
  const std::string& name() const override { return who; }
  void send(web::Lane, web::Bytes text) override {
    const json message = json::parse(*text);
    if (message["type"] == "state") state = message;
    if (message["type"] == "known") known = message;
    if (message["type"] == "refused") refused = message["text"];
    if (message["type"] != "lines") return;
    for (const json& line : message["lines"])
      lines.push_back(line[0].get<std::string>() + ": " + line[1].get<std::string>());
    next = message["first"].get<std::uint64_t>() + message["lines"].size();
    asks = true;
  }
  void sendBinary(web::Lane, web::Bytes) override {}
  void discardQueued() override {}
  std::uint64_t lost() const override { return 0; }
  void close(const std::string&) override {}

  std::string who = "page", refused;
  json state, known;
  std::vector<std::string> lines;
  std::uint64_t next = 0;
  bool asks = true;
};

struct WindowTransfer : testing::Test {
  void installerIs(const std::string& text) {
    std::ofstream{installer} << "#!/bin/sh\n" << text;
    chmod(installer.c_str(), 0700);
  }
  void open(TransferPage& one) {
    pages.push_back(&one);
    transfer->opened(one);
  }
  void turn() {
    for (TransferPage* one : pages)
      if (std::exchange(one->asks, false))
        transfer->received(*one, R"({"more": )" + std::to_string(one->next) + "}", false);
    now += window::Transfer::kLinesPause;
    transfer->update();
    std::this_thread::sleep_for(1ms);
  }
  template <class Done>
  void until(Done done) {
    const auto end = std::chrono::steady_clock::now() + 20s;
    while (!done() && std::chrono::steady_clock::now() < end) turn();
    ASSERT_TRUE(done()) << page.state << testing::PrintToString(page.lines);
  }
  void begin(const std::string& words = kStatus) { transfer->received(page, words, false); }
  void untilEnded() {
    until([this] { return !transfer->runs(); });
    for (int i = 0; i < 5; ++i) turn();
  }
  bool hasLine(const std::string& line) const { return std::ranges::find(page.lines, line) != page.lines.end(); }

  TemporaryFolder folder;
  std::string installer = folder / "darwinop-install", file = folder / "robots.json";
  Nanos now{0};
  TransferPage page, other;
  std::vector<TransferPage*> pages;
  std::unique_ptr<window::Transfer> transfer =
      std::make_unique<window::Transfer>(installer, file, [this] { return now; });
};

TEST_F(WindowTransfer, ShowsTheRunAndItsResultToEveryPage) {
  installerIs(
      "echo progress 1 2 0.5 connecting >&3\n"
      "echo \"$@\"; echo 'robot: error: no disk' >&2; exit 1\n");
  open(page);
  begin();
  untilEnded();
  EXPECT_THAT(page.lines, Contains("command: darwinop install --status darwin@r"));
  EXPECT_THAT(page.lines, Contains("output: --progress --status darwin@r"));
  EXPECT_THAT(page.lines, Contains("error: robot: error: no disk"));
  EXPECT_EQ(page.state["status"], 1);
  EXPECT_EQ(page.state["text"], "no disk");
  EXPECT_EQ(page.state["step"]["name"], "connecting");
  EXPECT_EQ(page.state["step"]["part"], 0.5);
  EXPECT_EQ(page.known["robots"][0]["address"], "r");
  open(other);  // after the end
  for (int i = 0; i < 3; ++i) turn();
  EXPECT_EQ(other.lines, page.lines);
  EXPECT_EQ(other.state, page.state);
}

TEST_F(WindowTransfer, ThePasswordReachesTheProgramOnlyAndOnce) {
  setenv("DARWINOP_PASSWORD", "ours", 1);  // of the window's own login
  installerIs("echo \"${DARWINOP_PASSWORD-none}\" >" + (folder / "") +
              "got; tr '\\0' ' ' </proc/$$/cmdline; echo; env | grep -c '^DARWINOP_PASSWORD='\n");
  open(page);
  transfer->received(page, "s3cret ü word", true);
  begin();
  untilEnded();
  const auto got = [this] {
    std::string text;
    std::ifstream in{folder / "got"};
    std::getline(in, text);
    return text;
  };
  EXPECT_EQ(got(), "s3cret ü word");
  EXPECT_TRUE(hasLine("output: 1"));
  for (const std::string& line : page.lines) EXPECT_THAT(line, Not(HasSubstr("s3cret")));
  EXPECT_THAT(page.state.dump() + page.known.dump(), Not(HasSubstr("s3cret")));
  std::string remembered{std::istreambuf_iterator<char>{std::ifstream{file}.rdbuf()}, {}};
  EXPECT_THAT(remembered, HasSubstr("darwin"));
  EXPECT_THAT(remembered, Not(HasSubstr("s3cret")));
  begin();  // the password was for the previous start
  untilEnded();
  EXPECT_EQ(got(), "none");
  unsetenv("DARWINOP_PASSWORD");
}

TEST_F(WindowTransfer, APasswordIsDiscardedWithItsStartAlsoIfThatIsRefused) {
  installerIs("echo \"${DARWINOP_PASSWORD-none}\"\n");
  open(page);
  transfer->received(page, "s3cret", true);
  begin(R"({"start": {"action": "status", "robot": {"address": "-r", "user": "darwin"}}})");
  EXPECT_THAT(page.refused, Not(IsEmpty()));
  EXPECT_FALSE(transfer->runs());
  begin();
  untilEnded();
  EXPECT_TRUE(hasLine("output: none"));
  transfer->received(page, "s3cret", true);
  transfer->received(page, std::string(201, 'a'), true);
  page.refused.clear();
  begin();  // neither without the rejected password nor with the previous one
  EXPECT_EQ(page.refused, window::messages::kInvalidPassword);
  EXPECT_FALSE(transfer->runs());
  begin();
  EXPECT_TRUE(transfer->runs());
  untilEnded();
  for (const std::string& line : page.lines) EXPECT_THAT(line, Not(HasSubstr("s3cret")));
}

TEST_F(WindowTransfer, CancelSendsCtrlCToTheGroupAndTheInstallerEndsItself) {
  installerIs(
      "trap 'echo asked; sleep 0.2; echo tidied; exit 130' INT\n"
      "sh -c \"trap 'echo child; exit' INT; echo begun; while :; do sleep 0.02; done\"; while :; do sleep 0.02; "
      "done\n");
  open(page);
  begin();
  until([this] { return hasLine("output: begun"); });
  transfer->received(page, R"({"cancel": true})", false);
  transfer->received(page, R"({"cancel": true})", false);
  EXPECT_EQ(page.state["cancelled"], true);
  begin();
  EXPECT_EQ(page.refused, window::messages::kAnotherTransferRuns);
  untilEnded();
  EXPECT_THAT(page.lines, Contains("output: child"));
  EXPECT_THAT(page.lines, Contains("output: tidied"));
  EXPECT_EQ(page.state["status"], 130);
  EXPECT_EQ(std::ranges::count(page.lines, "output: asked"), 1);
}

TEST_F(WindowTransfer, ClosingTheWindowCancelsTheRunAndWaits) {
  installerIs("trap 'yes | head -c 200000; echo tidied >" + (folder / "") +
              "end; exit 130' INT; echo begun; while :; do sleep 0.02; done\n");
  open(page);
  begin();
  until([this] { return hasLine("output: begun"); });
  transfer.reset();
  EXPECT_TRUE(std::filesystem::exists(folder / "end")) << "killed, or blocked on its output";
}

TEST_F(WindowTransfer, TheInstallerHasNoTerminalAndNoDescriptorsOfOurs) {
  const int leak = fcntl(1, F_DUPFD, 20);
  installerIs("(: </dev/tty) 2>/dev/null && echo terminal; read -r line || echo no input; ls /proc/$$/fd\n");
  open(page);
  begin();
  untilEnded();
  close(leak);
  EXPECT_THAT(page.lines, Contains("output: no input"));
  EXPECT_THAT(page.lines, Not(Contains("output: terminal")));
  EXPECT_THAT(page.lines, Contains("output: 3"));
  EXPECT_THAT(page.lines, Not(Contains("output: " + std::to_string(leak))));
}

TEST_F(WindowTransfer, EndlessOutputBlocksNothingAndLosesLinesOnly) {
  installerIs("yes 'a line of a controller that prints without end'\n");
  open(page);
  begin();
  until([this] { return page.lines.size() > 1000; });
  for (int i = 0; i < 200; ++i) {  // a slow page
    transfer->update();
    std::this_thread::sleep_for(1ms);
  }
  until([this] { return page.next > page.lines.size(); });  // some lines were dropped
  begin(R"({"cancel": true})");
  untilEnded();
}

TEST_F(WindowTransfer, RefusesInvalidRequestsAndAMissingInstaller) {
  open(page);
  begin("nonsense");
  EXPECT_EQ(page.refused, window::messages::kInvalidTransferRequest);
  begin();
  EXPECT_THAT(page.refused, HasSubstr("darwinop-install: No such file"));
  EXPECT_FALSE(transfer->runs());
  transfer->received(page, std::string(201, 'a'), true);
  EXPECT_EQ(page.refused, window::messages::kInvalidPassword);
}

TEST_F(WindowTransfer, SendsTheRobotOfTheCommandLineToPages) {
  open(page);
  EXPECT_TRUE(page.known["given"].is_null());
  const window::RobotAddress given{.address = "192.168.123.1", .user = "darwin", .key = "/k", .port = 2222};
  transfer = std::make_unique<window::Transfer>(
      installer, file, [this] { return now; }, given);
  transfer->opened(other);
  EXPECT_EQ(other.known["given"], window::jsonOf(given));
}

TEST_F(WindowTransfer, SendsTheKeyOfAnUnknownRobot) {
  const std::string key = "SHA256:" + std::string(43, 'A');
  installerIs("echo host-key " + key + " >&3; exit 1\n");
  open(page);
  begin();
  untilEnded();
  EXPECT_EQ(page.state["host_key"], key);
}

}  // namespace
}  // namespace darwinop
