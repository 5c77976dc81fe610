// Records every cycle to a CSV file (docs/logs.md). The loop only fills a ring buffer; another thread writes.
#pragma once

#include <atomic>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "hal/byte_line.hpp"
#include "runtime/log_file.hpp"
#include "runtime/log_row.hpp"
#include "runtime/ring.hpp"

namespace darwinop::runtime {

/// Header of a recording.
struct LogHead {
  std::string robot = "darwin-op";
  std::string model;  // description of the bus: serial port or simulation
  Nanos period{0};
  std::string notes{};  // further lines, "key: value"; empty: none
};

class Recorder {
 public:
  /// kThread: a thread of ordinary priority writes ten times a second. kByHand: the owner calls drain(); for lockstep,
  /// where no row may be lost.
  enum class Writer { kThread, kByHand };

  /// Opens the file. Throws std::runtime_error with the reason if that fails.
  Recorder(const std::string& path, const LogHead& head, Writer writer);
  /// Writes the remaining rows and the number of lost ones.
  ~Recorder();
  Recorder(const Recorder&) = delete;
  Recorder& operator=(const Recorder&) = delete;

  /// Loop's thread only. Wait-free; a row that does not fit is dropped and counted.
  void push(const Commands& asked, const Sensors& sensors) noexcept;

  /// For Writer::kByHand: writes all rows in the buffer.
  void drain();

 private:
  // 8 s at 16 ms, 2 MB: longer than the write stalls of an old SD card.
  static constexpr std::uint32_t kRows = 512;

  void writeHead(const LogHead& head);
  void writeRow(const LogRow& row);
  void put(const std::string& text) { check(failed_ ? 0 : file_.put(text)); }
  void check(int error);
  void run();

  std::string path_;
  LogFile file_;
  bool failed_ = false;  // a write failed; reported once, the loop continues
  std::unique_ptr<Ring<LogRow, kRows>> ring_;
  std::string line_;
  std::atomic<bool> stop_{false};
  std::thread thread_;
};

}  // namespace darwinop::runtime
