// Writes every cycle to a CSV file, docs/logs.md. The loop only fills a ring; somebody else writes.
#pragma once

#include <atomic>
#include <cstdio>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "hal/byte_line.hpp"
#include "runtime/log_row.hpp"
#include "runtime/ring.hpp"

namespace darwinop::runtime {

/// Comment before the number of rows that were lost; experiments/logs reads it.
inline constexpr const char* kLostRows = "# lost rows: ";

/// What the head of a recording says.
struct LogHead {
  std::string robot = "darwin-op";
  std::string model;  // what answered: a serial port, a simulation
  Nanos period{0};
  std::string notes{};  // further lines, "key: value", from the requester of the recording; empty: none
};

class Recorder {
 public:
  /// kThread: a thread of ordinary priority writes ten times a second. kByHand: drain() is called, as lockstep does
  /// it, where nothing may be lost and nothing depends on real time.
  enum class Writer { kThread, kByHand };

  /// Opens the file. Throws std::runtime_error that says why it cannot.
  Recorder(const std::string& path, const LogHead& head, Writer writer);
  /// Writes what is left and how many rows were lost.
  ~Recorder();
  Recorder(const Recorder&) = delete;
  Recorder& operator=(const Recorder&) = delete;

  /// Loop's thread only. Wait-free; a row that does not fit is dropped and counted.
  void push(const Commands& asked, const Sensors& sensors) noexcept;

  /// Writer kByHand: writes all rows there are.
  void drain();

 private:
  // Eight seconds at 16 ms, 2 MB: longer than an SD card of the robot's age stops to think.
  static constexpr std::uint32_t kRows = 512;

  void writeHead(const LogHead& head);
  void writeRow(const LogRow& row);
  void put(const std::string& text);
  void run();

  std::string path_;
  std::FILE* file_;
  bool failed_ = false;  // a write failed; reported once, the loop continues
  std::unique_ptr<Ring<LogRow, kRows>> ring_;
  std::string line_;
  std::atomic<bool> stop_{false};
  std::thread thread_;
};

}  // namespace darwinop::runtime
