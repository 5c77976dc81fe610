// Creates, maps and removes the exchange, in private memory or files.
#include "runtime/exchange.hpp"

#include <sys/mman.h>
#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <new>
#include <stdexcept>

#include "runtime/exchange_files.hpp"
#include "runtime/messages.hpp"

namespace darwinop::runtime {
namespace {

std::uint32_t newInstance() {
  timespec now{};
  clock_gettime(CLOCK_REALTIME, &now);
  return static_cast<std::uint32_t>(now.tv_sec) * 1'000'000'000U + static_cast<std::uint32_t>(now.tv_nsec);
}

}  // namespace

Exchange Exchange::inMemory() {
  Exchange exchange;
  exchange.private_block_ = std::make_unique<ExchangeBlock>();
  exchange.private_commands_ = std::make_unique<CommandBlock>();
  exchange.block_ = exchange.private_block_.get();
  exchange.commands_ = exchange.private_commands_.get();
  return exchange;
}

Exchange Exchange::embedded() {
  const char* path = std::getenv("DARWINOP_EXCHANGE");
  return path == nullptr || *path == '\0' ? inMemory() : createObservable(path);
}

Exchange Exchange::create(const std::string& path, gid_t group, const std::function<void(ExchangeBlock&)>& fill) {
  return made(path, group, true, fill);
}

Exchange Exchange::createObservable(const std::string& path, gid_t group) {
  return made(path, group, false, {});
}

Exchange Exchange::made(const std::string& path, gid_t group, bool commands_in_file,
                        const std::function<void(ExchangeBlock&)>& fill) {
  Exchange exchange;
  const std::uint32_t instance = newInstance();
  FreshFile block{path, 0640, group, sizeof(ExchangeBlock)};
  exchange.block_file_ = mapped(block.file(), path, sizeof(ExchangeBlock), PROT_READ | PROT_WRITE);
  exchange.block_ = new (exchange.block_file_.data()) ExchangeBlock{};
  exchange.block_->instance = instance;
  if (commands_in_file) {
    FreshFile commands{commandsPath(path), 0660, group, sizeof(CommandBlock)};
    exchange.commands_file_ = mapped(commands.file(), path, sizeof(CommandBlock), PROT_READ | PROT_WRITE);
    exchange.commands_ = new (exchange.commands_file_.data()) CommandBlock{};
    exchange.commands_->instance = instance;
    exchange.own_commands_ = commands.place();
  } else {
    unlink(commandsPath(path).c_str());
    exchange.private_commands_ = std::make_unique<CommandBlock>();
    exchange.commands_ = exchange.private_commands_.get();
  }
  if (fill) fill(*exchange.block_);
  exchange.own_block_ = block.place();
  return exchange;
}

void Exchange::remove(const std::string& path) noexcept {
  unlink(path.c_str());
  unlink((path + ".commands").c_str());
}

Exchange Exchange::attach(const std::string& path, Access access) {
  Exchange exchange;
  exchange.own_ = false;
  const Descriptor file = openedBlock(path);
  bool ours = hasSize(file, sizeof(ExchangeBlock));
  if (ours) {
    exchange.block_file_ = mapped(file, path, sizeof(ExchangeBlock), PROT_READ);
    exchange.block_ = static_cast<ExchangeBlock*>(exchange.block_file_.data());
    ours = exchange.block_->magic == ExchangeBlock::kMagic && exchange.block_->size == sizeof(ExchangeBlock) &&
           exchange.block_->layout == exchangeLayout();
  }
  if (!ours)
    throw std::runtime_error(path + messages::kOtherVersion +
                             "; build controller and runtime from "
                             "the same version, then restart the runtime");
  if (access == Access::kRead) return exchange;
  const Descriptor commands = openedCommands(commandsPath(path), userOf(file));
  if (hasSize(commands, sizeof(CommandBlock))) {
    exchange.commands_file_ = mapped(commands, path, sizeof(CommandBlock), PROT_READ | PROT_WRITE);
    exchange.commands_ = static_cast<CommandBlock*>(exchange.commands_file_.data());
  }
  if (exchange.commands_ == nullptr || exchange.commands_->instance != exchange.block_->instance)
    throw std::runtime_error(path + " and " + commandsPath(path) + messages::kNotOneRuntime +
                             ": the runtime is just being started, or one of them was "
                             "overwritten. Try again, then restart the runtime");
  return exchange;
}

bool Exchange::shortened() const {
  return lost() || (own_block_.fd() >= 0 && !hasSize(own_block_, sizeof(ExchangeBlock))) ||
         (own_commands_.fd() >= 0 && !hasSize(own_commands_, sizeof(CommandBlock)));
}

ExchangeBlock& Exchange::ownBlock() const {
  if (!own_) throw std::logic_error("another process hosts this loop");
  return *block_;
}

CommandBlock& Exchange::commands() const {
  if (commands_ == nullptr) throw std::logic_error("this exchange is open for reading only");
  return *commands_;
}

bool Exchange::lost() const noexcept {
  return block_file_.lost().load(std::memory_order_relaxed) || commands_file_.lost().load(std::memory_order_relaxed) ||
         block_->magic.load(std::memory_order_relaxed) != ExchangeBlock::kMagic;
}

void setText(char* to, std::size_t size, const std::string& text) {
  const std::size_t count = std::min(size - 1, text.size());
  std::copy_n(text.data(), count, to);
  to[count] = '\0';
}

}  // namespace darwinop::runtime
