#include "window/live/live_thread.hpp"

#include <pthread.h>
#include <sys/resource.h>
#include <time.h>
#include <unistd.h>

#include <exception>
#include <utility>

#include "runtime/clock.hpp"

namespace darwinop::window {
namespace {

using gap::live::LiveCycle;

constexpr std::size_t kCyclesOfReport = 8;       // a report is due at least so often while the twin is late
constexpr std::chrono::milliseconds kLook{100};  // how soon a request of the page is seen

/// Processor time of this thread.
double spentSeconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

}  // namespace

void LiveThread::start(const LiveSetting& setting) {
  {
    const std::scoped_lock lock{mutex_};
    wanted_ = setting;
    status_.runs = true;
  }
  changed_.notify_all();
  if (simulator_.joinable()) return;
  ends_ = false;
  reader_ = std::thread{[this] { read(); }};
  simulator_ = std::thread{[this] { simulate(); }};
}

void LiveThread::stop() {
  ends_ = true;
  changed_.notify_all();
  if (reader_.joinable()) reader_.join();
  if (simulator_.joinable()) simulator_.join();
  const std::scoped_lock lock{mutex_};
  status_.runs = false;
  waiting_.clear();
  wanted_.reset();
}

LiveStatus LiveThread::status() const {
  const std::scoped_lock lock{mutex_};
  return status_;
}

void LiveThread::read() {
  pthread_setname_np(pthread_self(), "darwinop-live");
  try {
    const std::unique_ptr<CycleSource> source = open_();
    const runtime::MonotonicClock clock;
    const CycleSource::Take take = [this](const LiveCycle& cycle) { put(cycle); };
    while (!ends_) {
      source->poll(clock.now(), take);
      {
        const std::scoped_lock lock{mutex_};
        if (status_.no_robot != source->reason()) status_.no_robot = source->reason();
      }
      std::this_thread::sleep_for(CycleSource::kPoll);
    }
  } catch (const std::exception& error) {
    const std::scoped_lock lock{mutex_};
    status_.no_robot = error.what();
  }
}

/// A full queue is emptied: the twin then begins again in the newest pose, instead of falling behind again and again.
void LiveThread::put(const LiveCycle& cycle) {
  {
    const std::scoped_lock lock{mutex_};
    if (waiting_.size() >= kMostWaiting) {
      status_.dropped += waiting_.size();
      waiting_.clear();
    }
    waiting_.push_back(cycle);
  }
  changed_.notify_all();
}

std::deque<LiveCycle> LiveThread::takeAll() {
  std::unique_lock lock{mutex_};
  changed_.wait_for(lock, kLook, [this] { return ends_ || wanted_ || !waiting_.empty(); });
  return std::exchange(waiting_, {});
}

void LiveThread::simulate() {
  pthread_setname_np(pthread_self(), "darwinop-twin");
  setpriority(PRIO_PROCESS, static_cast<id_t>(gettid()), kNice);
  while (!ends_) {
    const std::deque<LiveCycle> cycles = takeAll();
    std::optional<LiveSetting> wanted;
    {
      const std::scoped_lock lock{mutex_};
      wanted = std::exchange(wanted_, std::nullopt);
    }
    if (wanted) {
      begin(*wanted);
      continue;  // the cycles are older than the page's request
    }
    if (model_ && !cycles.empty()) advance(cycles);
  }
  comparison_.reset();
  model_.reset();
}

void LiveThread::begin(const LiveSetting& setting) {
  std::string error;
  comparison_.reset();
  model_.reset();
  try {
    model_ = twin::readModel(twin::findModel(setting.model));
  } catch (const std::exception& wrong) {
    error = wrong.what();
  }
  support_ = setting.support;
  spent_s_ = 0, stepped_ = 0;
  const std::scoped_lock lock{mutex_};
  waiting_.clear();
  if (status_.report.compared > 0 && !(setting == status_.setting)) {
    status_.setting_before = status_.setting;
    status_.before = status_.report;
  }
  status_.setting = setting;
  status_.error = error;
  status_.report = {};
  status_.dropped = 0;
  status_.step_s = 0;
}

void LiveThread::advance(const std::deque<LiveCycle>& cycles) {
  try {
    std::size_t since_report = 0;
    for (const LiveCycle& cycle : cycles) {
      if (ends_) return;
      const std::int64_t period = cycle.sensors.period_ns;
      if (!comparison_ || period != period_ns_)
        comparison_.emplace(*model_, support_, static_cast<double>(period) * 1e-9);
      period_ns_ = period;
      const double from = spentSeconds();
      comparison_->take(cycle);
      spent_s_ += spentSeconds() - from;
      ++stepped_;
      if (++since_report % kCyclesOfReport == 0 || since_report == cycles.size()) publish("");
    }
  } catch (const std::exception& wrong) {
    comparison_.reset();
    model_.reset();
    publish(wrong.what());
  }
}

void LiveThread::publish(const std::string& error) {
  const gap::live::LiveReport report = comparison_ ? comparison_->report() : gap::live::LiveReport{};
  const std::scoped_lock lock{mutex_};
  status_.report = report;
  status_.error = error;
  status_.period_s = static_cast<double>(period_ns_) * 1e-9;
  if (stepped_ > 0) status_.step_s = spent_s_ / static_cast<double>(stepped_);
}

}  // namespace darwinop::window
