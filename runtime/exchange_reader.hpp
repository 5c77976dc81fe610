// Reads an exchange without mapping it.
#pragma once

#include <sys/types.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "core/sensors.hpp"
#include "runtime/exchange.hpp"
#include "runtime/shared_file.hpp"

namespace darwinop::runtime {

/// For a process that must survive any change of the file: if it is shortened, read() fails, and nothing
/// else. 70 KiB are copied at each refresh.
class ExchangeReader {
 public:
  /// Nothing: there is no file, it must not be used, or it is not of this build.
  static std::optional<ExchangeReader> open(const std::string& path);

  /// Copies what the file says now. False: it is shorter than it was, or no exchange any more; the copy is then what it
  /// was before.
  [[nodiscard]] bool refresh();
  /// Of the last successful refresh.
  [[nodiscard]] const ExchangeBlock& block() const { return *copy_; }
  /// Newest value in the copy. False: there is none, or the loop overwrote it while it was copied; `into` keeps what it
  /// held.
  [[nodiscard]] bool sensors(Sensors& into) const;

 private:
  explicit ExchangeReader(SharedFile file) : file_{std::move(file)} {}

  SharedFile file_;
  std::unique_ptr<ExchangeBlock> copy_ = std::make_unique<ExchangeBlock>(), next_ = std::make_unique<ExchangeBlock>();
};

}  // namespace darwinop::runtime
