#include "runtime/exchange_reader.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cstddef>
#include <stdexcept>
#include <utility>

namespace darwinop::runtime {
namespace {

bool readsWhole(int fd, void* into, std::size_t size, std::size_t offset) {
  return pread(fd, into, size, static_cast<off_t>(offset)) == static_cast<ssize_t>(size);
}

}  // namespace

std::optional<ExchangeReader> ExchangeReader::open(const std::string& path) try {
  auto file = openShared(path, O_RDONLY, FileOwner::kGroup);
  if (!file) return std::nullopt;
  ExchangeReader reader{std::move(*file)};
  if (!reader.refresh()) return std::nullopt;
  return reader;
} catch (const std::runtime_error&) {
  return std::nullopt;
}

bool ExchangeReader::refresh() {
  if (!readsWhole(file_.fd(), next_.get(), sizeof(ExchangeBlock), 0)) return false;
  if (next_->magic != ExchangeBlock::kMagic || next_->size != sizeof(ExchangeBlock) ||
      next_->layout != exchangeLayout())
    return false;
  next_.swap(copy_);
  return true;
}

bool ExchangeReader::sensors(Sensors& into) const {
  Sensors seen;
  if (!copy_->sensors.read(seen)) return false;
  // The slot of publication n is refilled for publication n + kSlots, which begins after n + kSlots - 1 is counted.
  constexpr std::size_t kCount = offsetof(ExchangeBlock, sensors) + Latest<Sensors>::offsetOfCount();
  std::uint32_t later = 0;
  if (!readsWhole(file_.fd(), &later, sizeof later, kCount)) return false;
  if (later - copy_->sensors.count() > Latest<Sensors>::kSafeLead) return false;
  into = seen;
  return true;
}

}  // namespace darwinop::runtime
