// Creates, maps and removes the exchange, in private memory or files.
#include "runtime/exchange.hpp"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <new>
#include <optional>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "runtime/groups.hpp"
#include "runtime/messages.hpp"
#include "runtime/shared_file.hpp"

namespace darwinop::runtime {
namespace {

[[noreturn]] void fail(const std::string& what, int error, const std::string& remedy) {
  throw std::runtime_error(what + ": " + std::strerror(error) + (remedy.empty() ? "" : "; " + remedy));
}

std::string commandsPath(const std::string& path) {
  return path + ".commands";
}

GuardedMapping mapped(const SharedFile& file, const std::string& path, std::size_t size, int protection) try {
  return GuardedMapping{file.fd(), size, protection};
} catch (const std::system_error& error) {
  fail("cannot map " + path, error.code().value(), "");
}

/// True if the file belongs to another user.
std::string notPermitted(const std::string& path) {
  struct stat status {};
  if (stat(path.c_str(), &status) != 0) return "cannot open " + path + ": its folder may not be read";
  return messages::kOtherUsersRuntime + path + ") and you are not permitted to use it: only " + ownerOf(status) +
         " and group '" + groupName(status.st_gid) +
         "' are. Become a member of a group of your own choice, have the runtime started with --group GROUP, "
         "and log in again. If that runtime has ended, remove what is left of it: sudo rm " +
         path;
}

std::string whoHas(const std::string& path) {
  struct stat status {};
  if (lstat(path.c_str(), &status) != 0) return "choose another name with --name";
  return "it belongs to " + ownerOf(status) + ". Remove it (sudo rm " + path + "), or choose another name with --name";
}

/// A file under construction: created under another name, so that no process maps an incomplete block.
class FreshFile {
 public:
  FreshFile(std::string path, mode_t mode, gid_t group, std::size_t size)
      : path_{std::move(path)}, fresh_{path_ + ".XXXXXX"}, file_{opened(fresh_)} {
    if (fchmod(file_.fd(), mode) != 0 || fchown(file_.fd(), static_cast<uid_t>(-1), group) != 0) {
      const int error = errno;
      unlink(fresh_.c_str());
      fail("cannot give " + fresh_ + " to the group", error, "choose a group that you are a member of");
    }
    // Allocates the pages now: a full disk is an error here instead of a SIGBUS in the loop.
    if (const int error = posix_fallocate(file_.fd(), 0, static_cast<off_t>(size)); error != 0) {
      unlink(fresh_.c_str());
      fail("cannot get " + std::to_string(size) + " bytes for " + fresh_, error, "free some space");
    }
  }
  ~FreshFile() {
    if (!placed_) unlink(fresh_.c_str());
  }
  FreshFile(const FreshFile&) = delete;
  FreshFile& operator=(const FreshFile&) = delete;

  [[nodiscard]] const SharedFile& file() const { return file_; }
  /// Replaces a file of that name. Processes that map the old file keep it.
  SharedFile place() {
    if (rename(fresh_.c_str(), path_.c_str()) != 0) fail("cannot replace " + path_, errno, whoHas(path_));
    placed_ = true;
    return std::move(file_);
  }

 private:
  /// Under a name that no other user can take beforehand; with mode 0600.
  static SharedFile opened(std::string& fresh) {
    SharedFile file{mkostemp(fresh.data(), O_CLOEXEC)};
    if (file.fd() < 0) fail("cannot create " + fresh, errno, "is the folder there and yours to write?");
    return file;
  }

  std::string path_, fresh_;
  SharedFile file_;
  bool placed_ = false;
};

std::uint32_t newInstance() {
  timespec now{};
  clock_gettime(CLOCK_REALTIME, &now);
  return static_cast<std::uint32_t>(now.tv_sec) * 1'000'000'000U + static_cast<std::uint32_t>(now.tv_nsec);
}

bool hasSize(const SharedFile& file, std::size_t size) {
  struct stat status {};
  return fstat(file.fd(), &status) == 0 && status.st_size >= static_cast<off_t>(size);
}

uid_t userOf(const SharedFile& file) {
  struct stat status {};
  return fstat(file.fd(), &status) == 0 ? status.st_uid : static_cast<uid_t>(-1);
}

SharedFile openedBlock(const std::string& path) {
  if (auto file = openShared(path, O_RDONLY, FileOwner::kAny)) return std::move(*file);
  if (errno == EACCES) throw std::runtime_error(notPermitted(path));
  throw std::runtime_error(messages::kNoRuntime + path + " does not exist); " + messages::kStartRuntime);
}

SharedFile openedCommands(const std::string& path, uid_t user) {
  auto file = openShared(path, O_RDWR, FileOwner::kAny);
  if (!file && errno == EACCES) throw std::runtime_error(notPermitted(path));
  if (!file)
    throw std::runtime_error(messages::kTakesNoCommands + path +
                             " does not exist): a controller hosts it, or the supervisor brings the robot to rest");
  if (userOf(*file) != user)
    throw std::runtime_error(path + " is not used: " + whoHas(path) + ". The runtime is of another user");
  return std::move(*file);
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

Exchange Exchange::create(const std::string& path, gid_t group) {
  return made(path, group, true);
}

Exchange Exchange::createObservable(const std::string& path, gid_t group) {
  return made(path, group, false);
}

Exchange Exchange::made(const std::string& path, gid_t group, bool commands_in_file) {
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
  const SharedFile file = openedBlock(path);
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
  const SharedFile commands = openedCommands(commandsPath(path), userOf(file));
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
