// Recordings: written, read back, described.
#include "runtime/recorder.hpp"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <poll.h>
#include <pthread.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>
#include <thread>

#include "core/conversions.hpp"
#include "runtime/log_columns.hpp"
#include "runtime/messages.hpp"
#include "runtime/recording_file.hpp"
#include "support/temporary_folder.hpp"
#include "support/text_of.hpp"

namespace darwinop::runtime {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::ThrowsMessage;

/// What a spreadsheet makes of the file.
struct Table {
  std::vector<std::string> comments, columns;
  std::vector<std::map<std::string, std::string>> rows;

  explicit Table(const std::string& path) {
    std::ifstream file{path};
    for (std::string line; std::getline(file, line);) {
      if (line.starts_with('#')) {
        comments.push_back(line);
        continue;
      }
      std::vector<std::string> fields;
      std::stringstream stream{line + ","};
      for (std::string field; std::getline(stream, field, ',');) fields.push_back(field);
      if (columns.empty()) {
        columns = fields;
        continue;
      }
      if (fields.size() != columns.size()) throw std::runtime_error("a row of another length: " + line);
      rows.emplace_back();
      for (std::size_t i = 0; i < fields.size(); ++i) rows.back()[columns[i]] = fields[i];
    }
  }
};

Sensors sensorsOf(std::uint64_t cycle) {
  Sensors s;
  s.cycle = cycle;
  s.time_ns = 1'000'000'000 + static_cast<std::int64_t>(cycle) * 16'000'000;
  JointSensors& neck = s.joint[index(Joint::kNeck)];
  neck.motion.received();
  neck.position = radFromTicks(2049);
  neck.load = -0.25;
  JointSensors& head = s.joint[index(Joint::kHead)];
  head.motion.age = 1;  // was received in the cycle before
  head.position = Rad{0.5};
  return s;
}

TEST(Recorder, WhatIsReadBackIsWhatTheLoopSaw) {
  const TemporaryFolder folder;
  {
    Recorder recorder{folder / "log.csv", {"Darwin 7", "test", Nanos{16'000'000}}, Recorder::Writer::kByHand};
    Commands asked;
    asked.joint[index(Joint::kNeck)].setGoal(Rad{-0.1});
    for (std::uint64_t cycle = 1; cycle <= 3; ++cycle) recorder.push(asked, sensorsOf(cycle));
  }
  const Table table{folder / "log.csv"};
  ASSERT_EQ(table.rows.size(), 3u);
  EXPECT_EQ(table.columns.at(0), "time_s");
  EXPECT_EQ(table.columns.at(1), "cycle");
  EXPECT_EQ(table.rows[1].at("time_s"), "1.032000");
  EXPECT_EQ(table.rows[1].at("cycle"), "2");
  EXPECT_NEAR(std::stod(table.rows[0].at("Neck.position [rad]")), kRadPerTick, 1e-9);
  EXPECT_EQ(table.rows[0].at("Neck.load"), "-0.25");
  EXPECT_EQ(table.rows[0].at("Neck.asked [rad]"), "-0.1");
}

TEST(Recorder, LeavesAFieldEmptyForWhatWasNotAskedNotReceivedOrNotReceivedInThisCycle) {
  const TemporaryFolder folder;
  { Recorder{folder / "log.csv", {}, Recorder::Writer::kByHand}.push(Commands{}, sensorsOf(1)); }
  const Table table{folder / "log.csv"};
  for (const char* name : {"Neck.asked [rad]", "Neck.commanded [rad]", "Head.position [rad]", "FootL.position [rad]",
                           "gyro.x [rad/s]", "Neck.temperature [degC]"})
    EXPECT_EQ(table.rows.at(0).at(name), "") << name;
}

TEST(Recorder, HeadNamesRobotModelVersionDateAndPeriod) {
  const TemporaryFolder folder;
  {
    const Recorder recorder{
        folder / "log.csv", {"Darwin 7", "/dev/ttyUSB0", Nanos{8'000'000}}, Recorder::Writer::kByHand};
  }
  const Table table{folder / "log.csv"};
  for (const char* line : {"# robot: Darwin 7", "# model: /dev/ttyUSB0", "# period_s: 0.008"})
    EXPECT_THAT(table.comments, Contains(line));
  EXPECT_THAT(table.comments, Contains(HasSubstr("# version: ")));
  EXPECT_THAT(table.comments, Contains(testing::ContainsRegex("# date: 2...-..-..T..:..:..Z")));
  EXPECT_EQ(table.comments.back(), "# end");
}

TEST(Recorder, CountsRowsThatDidNotFitAndSaysSoAtTheEnd) {
  const TemporaryFolder folder;
  {
    Recorder recorder{folder / "log.csv", {}, Recorder::Writer::kByHand};
    for (std::uint64_t cycle = 1; cycle <= 600; ++cycle) recorder.push(Commands{}, sensorsOf(cycle));
  }
  const Table table{folder / "log.csv"};
  EXPECT_EQ(table.rows.size(), 512u);
  EXPECT_THAT(table.comments, Contains(HasSubstr(kLostRows + std::string{"88"})));
}

TEST(Recorder, ARecordingWithLostRowsIsNotComplete) {
  const TemporaryFolder folder;
  const std::string path = folder / "log.csv";
  testing::internal::CaptureStderr();
  {
    Recorder recorder{path, {}, Recorder::Writer::kByHand};
    for (std::uint64_t cycle = 1; cycle <= 600; ++cycle) recorder.push(Commands{}, sensorsOf(cycle));
  }
  EXPECT_THAT(testing::internal::GetCapturedStderr(), HasSubstr(path + " lacks 88" + messages::kRowsLost));
  EXPECT_FALSE(isCompleteRecording(path));
}

TEST(Recorder, ThreadWritesEverythingBeforeItEnds) {
  const TemporaryFolder folder;
  {
    Recorder recorder{folder / "log.csv", {}, Recorder::Writer::kThread};
    for (std::uint64_t cycle = 1; cycle <= 300; ++cycle) recorder.push(Commands{}, sensorsOf(cycle));
  }
  EXPECT_EQ(Table{folder / "log.csv"}.rows.size(), 300u);
}

TEST(Recorder, SaysWhyItCannotBegin) {
  try {
    Recorder{"/no/such/folder/log.csv", {}, Recorder::Writer::kByHand};
    FAIL() << "accepted";
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), HasSubstr("/no/such/folder/log.csv"));
    EXPECT_THAT(error.what(), HasSubstr("--record"));
  }
}

TEST(Recorder, ReplacesARecordingOrAnEmptyFileButNoOther) {
  const TemporaryFolder folder;
  const std::string path = folder / "controller.py";
  std::ofstream{path} << "from controller import Robot\n";
  EXPECT_THAT([&] { Recorder(path, {}, Recorder::Writer::kByHand); },
              ThrowsMessage<std::runtime_error>(path + messages::kNotARecording));
  EXPECT_EQ(std::filesystem::file_size(path), 29u);
  std::filesystem::resize_file(path, 0);
  for (int i = 0; i < 2; ++i) {
    (void)Recorder{path, {}, Recorder::Writer::kByHand};
    EXPECT_TRUE(isCompleteRecording(path));
  }
}

TEST(Recorder, GoesOnWhenTheDiskIsFull) {
  testing::internal::CaptureStderr();
  {
    Recorder recorder{"/dev/full", {}, Recorder::Writer::kByHand};
    for (std::uint64_t cycle = 1; cycle <= 400; ++cycle) {
      recorder.push(Commands{}, sensorsOf(cycle));
      recorder.drain();
    }
  }
  const std::string said = testing::internal::GetCapturedStderr();
  EXPECT_THAT(said, HasSubstr(std::strerror(ENOSPC)));
  EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), 1) << said;
}

std::atomic<int> interruptions{0};

/// A pipe that its reader does not empty until this thread, which writes the recording, was interrupted several times.
TEST(Recorder, SurvivesCtrlCWhileAPipeIsFull) {
  std::array<int, 2> pipe_ends{};
  ASSERT_EQ(pipe2(pipe_ends.data(), O_CLOEXEC), 0);
  const int read_end = pipe_ends[0], write_end = pipe_ends[1];
  ASSERT_EQ(fcntl(write_end, F_SETFL, O_NONBLOCK), 0);
  std::array<char, 4096> part{};
  while (write(write_end, part.data(), part.size()) > 0) {
  }
  ASSERT_GT(read(read_end, part.data(), part.size()), 0);  // room for less than the header
  struct sigaction interrupt {
  }, before{};
  interruptions = 0;
  interrupt.sa_handler = [](int) { ++interruptions; };  // without SA_RESTART
  sigaction(SIGINT, &interrupt, &before);
  std::string read_back;
  std::thread reader{[&, writer = pthread_self()] {
    for (pollfd room{write_end, POLLOUT, 0}; poll(&room, 1, 0) == 1;) std::this_thread::yield();
    // Sent until handled: ThreadSanitizer keeps a signal that comes just before the write until the write ends.
    while (interruptions < 50) {
      pthread_kill(writer, SIGINT);
      std::this_thread::sleep_for(std::chrono::microseconds{100});
    }
    close(write_end);
    for (ssize_t count = 0; (count = read(read_end, part.data(), part.size())) > 0;)
      read_back.append(part.data(), static_cast<std::size_t>(count));
  }};
  testing::internal::CaptureStderr();
  {
    Recorder recorder{"/dev/fd/" + std::to_string(write_end), {}, Recorder::Writer::kByHand};
    recorder.push(Commands{}, sensorsOf(1));
    recorder.drain();
  }
  reader.join();
  sigaction(SIGINT, &before, nullptr);
  close(read_end);
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  EXPECT_THAT(read_back, testing::EndsWith("\n# end\n"));
}

TEST(LogColumns, AreAllDescribedInTheDocumentationWithTheirUnits) {
  const std::string text = textOf(DARWINOP_SOURCE_DIR "/docs/logs.md");
  const auto line = [](std::string_view name, std::string_view unit, std::string_view meaning) {
    return "| `" + std::string{name} + "` | " + std::string{unit} + " | " + std::string{meaning} + " |";
  };
  for (const LogColumn& c : kLogColumns) EXPECT_THAT(text, HasSubstr(line(c.name, c.unit, c.meaning)));
  for (const JointLogColumn& c : kJointLogColumns)
    EXPECT_THAT(text, HasSubstr(line("<joint>." + std::string{c.name}, c.unit, c.meaning)));
}

}  // namespace
}  // namespace darwinop::runtime
