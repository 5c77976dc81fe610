#include "gap/parallel/parallel.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace darwinop::gap {
namespace {

std::atomic<unsigned> allowed{0};
thread_local bool inside = false;

unsigned threadsFor(std::size_t count) {
  const unsigned wanted = allowed.load() == 0 ? std::max(1U, std::thread::hardware_concurrency()) : allowed.load();
  return inside ? 1 : static_cast<unsigned>(std::min<std::size_t>(wanted, count));
}

}  // namespace

void setThreads(unsigned threads) {
  allowed = threads;
}

void forEach(std::size_t count, const std::function<void(std::size_t)>& work) {
  const unsigned threads = threadsFor(count);
  if (threads <= 1) {
    for (std::size_t i = 0; i < count; ++i) work(i);
    return;
  }
  std::atomic<std::size_t> next{0};
  std::exception_ptr failure;
  std::mutex failing;
  const auto take = [&] {
    inside = true;
    try {
      for (std::size_t i = 0; (i = next++) < count;) work(i);
    } catch (...) {
      const std::lock_guard lock{failing};
      if (!failure) failure = std::current_exception();
      next = count;
    }
    inside = false;
  };
  std::vector<std::jthread> others;
  for (unsigned i = 1; i < threads; ++i) others.emplace_back(take);
  take();
  others.clear();
  if (failure) std::rethrow_exception(failure);
}

}  // namespace darwinop::gap
