// A line that is recorded once and then replayed: the loop under test meets the same bytes and times at almost no
// cost of the far end.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "hil-mocks/memory_line.hpp"
#include "runtime/clock.hpp"

namespace darwinop::bench {

/// All that a line said, in order.
struct Recording {
  struct Read {
    LineStatus status;
    std::size_t begin, count;  // in `bytes`
  };
  std::vector<Nanos> times;
  std::vector<Read> reads;
  std::vector<std::uint8_t> bytes;
};

/// Passes everything on to a virtual robot in memory and keeps what it said.
class RecordingLine final : public ByteLine {
 public:
  RecordingLine(hil::MemoryLine& line, Recording& recording) : line_{line}, recording_{recording} {}

  [[nodiscard]] Nanos now() noexcept override { return recording_.times.emplace_back(line_.now()); }
  LineStatus write(std::span<const std::uint8_t> bytes) noexcept override { return line_.write(bytes); }
  LineStatus read(std::span<std::uint8_t> into, std::size_t& count, Nanos deadline) noexcept override {
    const LineStatus status = line_.read(into, count, deadline);
    recording_.reads.push_back({status, recording_.bytes.size(), count});
    recording_.bytes.insert(recording_.bytes.end(), into.begin(), into.begin() + static_cast<std::ptrdiff_t>(count));
    return status;
  }
  void discardInput() noexcept override { line_.discardInput(); }
  [[nodiscard]] std::uint32_t reconnects() const noexcept override { return line_.reconnects(); }
  void sleepUntil(Nanos time) noexcept { line_.advanceTo(time); }

 private:
  hil::MemoryLine& line_;
  Recording& recording_;
};

/// Says it again. Writes are taken and forgotten.
class ReplayLine final : public ByteLine {
 public:
  explicit ReplayLine(const Recording& recording) : recording_{recording} {}

  [[nodiscard]] Nanos now() noexcept override { return recording_.times.at(time_++); }
  LineStatus write(std::span<const std::uint8_t>) noexcept override { return LineStatus::kOk; }
  LineStatus read(std::span<std::uint8_t> into, std::size_t& count, Nanos) noexcept override {
    const Recording::Read& read = recording_.reads.at(read_++);
    std::copy_n(recording_.bytes.begin() + static_cast<std::ptrdiff_t>(read.begin), read.count, into.begin());
    count = read.count;
    return read.status;
  }
  void discardInput() noexcept override {}
  [[nodiscard]] std::uint32_t reconnects() const noexcept override { return 0; }
  void sleepUntil(Nanos) noexcept {}

 private:
  const Recording& recording_;
  std::size_t time_ = 0, read_ = 0;
};

/// The loop's clock is the line's.
template <class Line>
class LineClock final : public runtime::Clock {
 public:
  explicit LineClock(Line& line) : line_{line} {}
  [[nodiscard]] Nanos now() const noexcept override { return line_.now(); }
  void sleepUntil(Nanos time) noexcept override { line_.sleepUntil(time); }

 private:
  Line& line_;
};

}  // namespace darwinop::bench
