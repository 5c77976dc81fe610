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

/// For a process that must survive any change of the file: if it is truncated, only refresh() fails. Each refresh
/// copies 70 KiB.
class ExchangeReader {
 public:
  /// Nothing: there is no file, its owner or permissions are not trusted, or another build wrote it.
  static std::optional<ExchangeReader> open(const std::string& path);

  /// Copies the file. False: it was truncated or is not an exchange any more; the previous copy is kept.
  [[nodiscard]] bool refresh();
  /// The copy of the last successful refresh.
  [[nodiscard]] const ExchangeBlock& block() const { return *copy_; }
  /// Newest sensor image in the copy. False: there is none, or the loop overwrote it during the copy; `into` is then
  /// unchanged.
  [[nodiscard]] bool sensors(Sensors& into) const;

 private:
  explicit ExchangeReader(Descriptor file) : file_{std::move(file)} {}

  Descriptor file_;
  std::unique_ptr<ExchangeBlock> copy_ = std::make_unique<ExchangeBlock>(), next_ = std::make_unique<ExchangeBlock>();
};

}  // namespace darwinop::runtime
