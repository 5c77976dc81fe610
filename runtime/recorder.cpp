// Records every cycle to a CSV file.
#include "runtime/recorder.hpp"

#include <pthread.h>
#include <signal.h>
#include <time.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <iostream>
#include <stdexcept>
#include <system_error>

#include "runtime/log_columns.hpp"
#include "runtime/messages.hpp"
#include "runtime/recording_file.hpp"
#include "runtime/version.hpp"

namespace darwinop::runtime {
namespace {

/// Integers exactly, other numbers with seven digits: 0.1 microradian resolution at pi. NaN: an empty field.
void append(std::string& line, double value) {
  if (std::isnan(value)) return;
  char text[40];
  const bool whole = value == std::nearbyint(value) && std::abs(value) < 9e15;
  const auto end = whole ? std::to_chars(text, text + sizeof text, static_cast<long long>(value))
                         : std::to_chars(text, text + sizeof text, value, std::chars_format::general, 7);
  line.append(text, end.ptr);
}

void appendSeconds(std::string& line, std::int64_t ns) {
  char text[40];
  const int length = std::snprintf(text, sizeof text, "%lld.%06lld", static_cast<long long>(ns / 1'000'000'000),
                                   static_cast<long long>(ns % 1'000'000'000 / 1000));
  line.append(text, static_cast<std::size_t>(length));
}

void appendName(std::string& line, std::string_view name, std::string_view unit) {
  line += name;
  if (!unit.empty()) line.append(" [").append(unit).append("]");
}

/// Prefixes each line as a header comment.
std::string commented(std::string_view lines) {
  std::string text;
  while (!lines.empty()) {
    const std::size_t length = std::min(lines.find('\n'), lines.size());
    if (length > 0) text.append("# ").append(lines.substr(0, length)).append("\n");
    lines.remove_prefix(std::min(length + 1, lines.size()));
  }
  return text;
}

LogFile openRecording(const std::string& path) try {
  requireReplaceableRecording(path);
  return LogFile{path};
} catch (const std::system_error& error) {
  throw std::runtime_error("cannot write the recording " + path + ": " + std::strerror(error.code().value()) +
                           "; choose another file with --record");
}

std::string today() {
  const time_t now = time(nullptr);
  tm utc{};
  gmtime_r(&now, &utc);
  char text[32];
  return {text, strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &utc)};
}

}  // namespace

Recorder::Recorder(const std::string& path, const LogHead& head, Writer writer)
    : path_{path}, file_{openRecording(path)}, ring_{std::make_unique<Ring<LogRow, kRows>>()} {
  line_.reserve(8192);
  writeHead(head);
  if (writer == Writer::kThread) thread_ = std::thread{[this] { run(); }};
}

Recorder::~Recorder() {
  stop_.store(true, std::memory_order_relaxed);
  if (thread_.joinable()) thread_.join();
  drain();
  if (const std::uint32_t lost = ring_->dropped(); lost != 0) {
    put(kLostRows + std::to_string(lost) + " (the disk was too slow)\n");
    std::cerr << "the recording " << path_ << " lacks " << lost << messages::kRowsLost << '\n';
  }
  put(kEndOfRecording);
  if (!failed_) check(file_.close());
}

void Recorder::push(const Commands& asked, const Sensors& sensors) noexcept {
  ring_->push(LogRow{asked, sensors});
}

void Recorder::drain() {
  while (const LogRow* row = ring_->front()) {
    writeRow(*row);
    ring_->pop();
  }
  if (!failed_) check(file_.flush());
}

void Recorder::run() {
  pthread_setname_np(pthread_self(), "darwinop-record");
  sigset_t all;  // signals must interrupt the controller's thread, not this one
  sigfillset(&all);
  pthread_sigmask(SIG_BLOCK, &all, nullptr);
  const timespec pause{0, 100'000'000};
  while (!stop_.load(std::memory_order_relaxed)) {
    drain();
    nanosleep(&pause, nullptr);
  }
}

void Recorder::writeHead(const LogHead& head) {
  std::string text = kRecordingHead + ("# robot: " + head.robot) + "\n# model: " + head.model +
                     "\n# version: " + version() + "\n# date: " + today() + "\n# period_s: ";
  append(text, std::chrono::duration<double>(head.period).count());
  text += "\n" + commented(head.notes) + "# safety.state:";
  for (std::size_t i = 0; i < kStates; ++i)
    text.append(" ").append(std::to_string(i)).append(" ").append(kStateNames[i]);
  text += "\n";
  for (const LogColumn& column : kLogColumns) {
    if (&column != kLogColumns.data()) text += ',';
    appendName(text, column.name, column.unit);
  }
  for (const JointRow& joint : kJointTable)
    for (const JointLogColumn& column : kJointLogColumns)
      appendName(text, "," + std::string{joint.name} + "." + std::string{column.name}, column.unit);
  put(text + "\n");
}

void Recorder::writeRow(const LogRow& row) {
  line_.clear();
  appendSeconds(line_, row.sensors.time_ns);
  for (std::size_t i = 1; i < kLogColumns.size(); ++i) {
    line_ += ',';
    append(line_, kLogColumns[i].get(row));
  }
  for (std::size_t joint = 0; joint < kJoints; ++joint)
    for (const JointLogColumn& column : kJointLogColumns) {
      line_ += ',';
      append(line_, column.get(row.asked.joint[joint], row.sensors.joint[joint]));
    }
  line_ += '\n';
  put(line_);
}

void Recorder::check(int error) {
  if (error == 0) return;
  failed_ = true;
  std::cerr << "the recording " << path_ << " ends here: " << std::strerror(error) << "; the loop continues\n";
}

}  // namespace darwinop::runtime
