// Doctor channel with a shell script as darwinop-doctor.
#include "window/doctor/doctor_channel.hpp"

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
using testing::HasSubstr;

constexpr const char* kCheck = R"({"check": true})";

struct DoctorPage final : web::Channel {
  const std::string& name() const override { return who; }
  void send(web::Lane, web::Bytes text) override { state = json::parse(*text); }
  void sendBinary(web::Lane, web::Bytes) override {}
  void discardQueued() override {}
  std::uint64_t lost() const override { return 0; }
  void close(const std::string& why) override { closed = why; }

  std::string who = "page", closed;
  json state;
};

struct WindowDoctor : testing::Test {
  void doctorIs(const std::string& text) {
    std::ofstream{program} << "#!/bin/sh\n" << text;
    chmod(program.c_str(), 0700);
  }
  void open(const window::RobotChoice& choice, const std::string& own_port = "") {
    channel = std::make_unique<window::DoctorChannel>(window::doctorCommand(choice, program, own_port));
    channel->opened(page);
  }
  void check() { channel->received(page, kCheck, false); }
  void untilEnded() {
    const auto end = std::chrono::steady_clock::now() + 20s;
    while (page.state["runs"] == true && std::chrono::steady_clock::now() < end) {
      channel->update();
      std::this_thread::sleep_for(1ms);
    }
    ASSERT_EQ(page.state["runs"], false);
  }

  TemporaryFolder folder;
  std::string program = folder / "darwinop-doctor";
  DoctorPage page, other;
  std::unique_ptr<window::DoctorChannel> channel;
};

TEST_F(WindowDoctor, EveryPageGetsTheDocumentAsItWasPrinted) {
  doctorIs("echo \"{\\\"faults\\\": [], \\\"words\\\": \\\"$*\\\"}\"; exit 1\n");
  open({.robot = "twin"}, "/tmp/robot");
  channel->opened(other);
  EXPECT_EQ(page.state["document"], nullptr);
  check();
  EXPECT_EQ(page.state["runs"], true);
  untilEnded();
  EXPECT_EQ(page.state["document"], (json{{"faults", json::array()}, {"words", "--robot /tmp/robot --json"}}));
  EXPECT_EQ(page.state["command"], "darwinop doctor --robot /tmp/robot");
  EXPECT_EQ(page.state["error"], nullptr);
  EXPECT_EQ(other.state, page.state);
}

TEST_F(WindowDoctor, ANewRunForgetsTheOldDocumentAndASecondOneDoesNotStartMeanwhile) {
  const std::string runs = folder / "runs";
  doctorIs("echo run >>" + runs + "\nsleep 0.2\necho '{}'\n");
  open({.robot = "runtime"});
  check();
  check();
  untilEnded();
  EXPECT_EQ(page.state["document"], json::object());
  check();
  EXPECT_EQ(page.state["document"], nullptr);
  untilEnded();
  std::ifstream lines{runs};
  EXPECT_EQ(std::count(std::istreambuf_iterator<char>{lines}, {}, '\n'), 2);
}

TEST_F(WindowDoctor, WithoutADocumentThePageGetsTheReason) {
  doctorIs("echo \"darwinop doctor: no robot there\" >&2; exit 1\n");
  open({.robot = "runtime"});
  check();
  untilEnded();
  EXPECT_EQ(page.state["document"], nullptr);
  EXPECT_EQ(page.state["error"], "no robot there");

  doctorIs("exit 3\n");
  check();
  untilEnded();
  EXPECT_EQ(page.state["error"], window::messages::kNoDoctorDocument + std::string{"3"});
}

TEST_F(WindowDoctor, AMissingProgramIsAnError) {
  open({.robot = "runtime"});
  check();
  EXPECT_EQ(page.state["runs"], false);
  EXPECT_THAT(page.state["error"].get<std::string>(), HasSubstr(program));
}

TEST_F(WindowDoctor, EndlessOutputNeitherBlocksNorGrows) {
  doctorIs("head -c 3000000 /dev/zero | tr '\\0' '['\n");
  open({.robot = "runtime"});
  check();
  untilEnded();
  EXPECT_EQ(page.state["document"], nullptr);
  EXPECT_NE(page.state["error"], nullptr);
}

TEST_F(WindowDoctor, ARobotOnAnotherComputerIsCheckedThere) {
  doctorIs("echo '{}'\n");
  for (const window::RobotChoice& choice :
       {window::RobotChoice{.robot = "tcp://10.0.0.7"}, window::RobotChoice{.robot = "runtime", .monitor = "10.0.0.7"},
        window::RobotChoice{.robot = "tcp://127.0.0.1:4711", .logged_in_to = "darwin@10.0.0.7"}}) {
    open(choice);
    check();
    EXPECT_EQ(page.state["runs"], false) << choice.robot;
    EXPECT_THAT(page.state["elsewhere"].get<std::string>(), HasSubstr(window::messages::kDoctorThere));
  }
  EXPECT_THAT(page.state["elsewhere"].get<std::string>(), HasSubstr("ssh darwin@10.0.0.7 "));
}

TEST_F(WindowDoctor, AnotherRequestClosesTheChannel) {
  open({.robot = "runtime"});
  for (const char* request : {"", "{}", "{\"check\": 1}", "{\"check\": true, \"fix\": true}", "[[[["}) {
    page.closed.clear();
    channel->received(page, request, false);
    EXPECT_EQ(page.closed, window::messages::kInvalidDoctorRequest) << request;
    EXPECT_EQ(page.state["runs"], false);
  }
}

}  // namespace
}  // namespace darwinop
