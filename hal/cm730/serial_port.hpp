// Serial port as a byte line, with bounded blocking and automatic reconnection.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "hal/byte_line.hpp"
#include "hal/cm730/port_keeper.hpp"

namespace darwinop::cm730 {

class SerialPort final : public ByteLine {
 public:
  /// A tty, a pty, or a link to one. Throws std::runtime_error with a remedy; NotReady if retrying is useful.
  explicit SerialPort(const std::string& path);
  /// For tests: an open descriptor, and the configuration for reopening it.
  SerialPort(int fd, PortKeeper::Config keeper);
  ~SerialPort() override;
  SerialPort(const SerialPort&) = delete;
  SerialPort& operator=(const SerialPort&) = delete;

  [[nodiscard]] Nanos now() noexcept override;
  LineStatus write(std::span<const std::uint8_t> bytes) noexcept override;
  LineStatus read(std::span<std::uint8_t> into, std::size_t& count, Nanos deadline) noexcept override;
  void discardInput() noexcept override;
  [[nodiscard]] std::uint32_t reconnects() const noexcept override { return reconnects_; }

 private:
  [[nodiscard]] bool present() noexcept;
  LineStatus lose() noexcept;
  /// Waits for one of `events`. kOk: retry; if that transfers nothing and `hung_up` is true, the port is lost.
  LineStatus wait(short events, Nanos deadline, bool& hung_up) noexcept;

  int fd_;
  std::uint32_t reconnects_ = 0;
  PortKeeper keeper_;
};

}  // namespace darwinop::cm730
