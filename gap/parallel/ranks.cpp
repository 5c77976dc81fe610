#include "gap/parallel/ranks.hpp"

#include <sched.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <stdexcept>
#include <thread>

#include "gap/parallel/parallel.hpp"

#define OMPI_SKIP_MPICXX 1  // the C++ interface that MPI 3 took out
#include <mpi.h>

namespace darwinop::gap {
namespace {

struct Joined {
  int own = 0, count = 1;
  unsigned on_same_cores = 1;
  std::thread::id thread;
};
Joined joined;  // NOLINT(cppcoreguidelines-avoid-non-const-global-variables): as MPI itself, once a process

/// Environment variable of mpirun, or of another launcher that OpenMPI supports.
bool startedByMpi() {
  return std::getenv("OMPI_COMM_WORLD_SIZE") != nullptr || std::getenv("PMIX_RANK") != nullptr;
}

/// Host, and the first core that this process may run on: ranks of which both are equal share their cores.
std::array<std::size_t, 2> whereWeRun() {
  std::array<char, 256> host{};
  gethostname(host.data(), host.size() - 1);
  cpu_set_t mask;
  CPU_ZERO(&mask);
  sched_getaffinity(0, sizeof mask, &mask);
  std::size_t first = 0;
  while (first < CPU_SETSIZE && !CPU_ISSET(first, &mask)) ++first;
  return {std::hash<std::string>{}(host.data()), first};
}

unsigned ranksOnTheseCores(int count) {
  const auto own = whereWeRun();
  std::vector<std::array<std::size_t, 2>> all(static_cast<std::size_t>(count));
  MPI_Allgather(own.data(), sizeof own, MPI_BYTE, all.data(), sizeof own, MPI_BYTE, MPI_COMM_WORLD);
  return static_cast<unsigned>(std::ranges::count(all, own));
}

bool isShared() {
  return joined.count > 1 && std::this_thread::get_id() == joined.thread;
}

/// Ranks at different work would wait for each other forever, or exchange wrong rows.
void expectSameWork(std::size_t count, std::size_t width) {
  const std::array<std::size_t, 2> own{count, width};
  std::vector<std::array<std::size_t, 2>> all(static_cast<std::size_t>(joined.count));
  MPI_Allgather(own.data(), sizeof own, MPI_BYTE, all.data(), sizeof own, MPI_BYTE, MPI_COMM_WORLD);
  if (std::ranges::count(all, own) != joined.count)
    throw std::runtime_error(
        "the ranks of mpirun have come to different results; give them processors of one kind, or use one rank");
}

}  // namespace

Ranks::Ranks() {
  if (!startedByMpi()) return;
  int level = 0;
  MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &level);
  MPI_Comm_rank(MPI_COMM_WORLD, &joined.own);
  MPI_Comm_size(MPI_COMM_WORLD, &joined.count);
  joined.thread = std::this_thread::get_id();
  joined.on_same_cores = ranksOnTheseCores(joined.count);
}

Ranks::~Ranks() {
  int is_joined = 0;
  MPI_Initialized(&is_joined);
  if (is_joined != 0) MPI_Finalize();
  joined = {};
}

int Ranks::own() {
  return joined.own;
}

int Ranks::count() {
  return joined.count;
}

unsigned Ranks::cores() {
  return std::max(1U, std::thread::hardware_concurrency() / joined.on_same_cores);
}

int Ranks::giveUp(int code) {
  if (joined.count > 1) MPI_Abort(MPI_COMM_WORLD, code);
  return code;
}

// Row i is that of rank i modulo their number: neighbours cost about the same.
std::vector<double> sharedRows(std::size_t count, std::size_t width,
                               const std::function<void(std::size_t, std::span<double>)>& work) {
  const bool shared = isShared();
  const auto ranks = shared ? static_cast<std::size_t>(joined.count) : 1;
  const auto own = shared ? static_cast<std::size_t>(joined.own) : 0;
  if (shared) expectSameWork(count, width);
  const std::size_t most = (count + ranks - 1) / ranks;
  std::vector<double> mine(most * width);
  forEach(most, [&](std::size_t at) {
    const std::size_t i = at * ranks + own;
    if (i < count) work(i, std::span{mine}.subspan(at * width, width));
  });
  if (!shared) return mine;
  std::vector<double> all(ranks * most * width), rows(count * width);
  const int size = static_cast<int>(mine.size());
  MPI_Allgather(mine.data(), size, MPI_DOUBLE, all.data(), size, MPI_DOUBLE, MPI_COMM_WORLD);
  for (std::size_t i = 0; i < count; ++i)
    std::copy_n(all.begin() + static_cast<std::ptrdiff_t>((i % ranks * most + i / ranks) * width), width,
                rows.begin() + static_cast<std::ptrdiff_t>(i * width));
  return rows;
}

void sendTo(int rank, const std::string& text) {
  MPI_Send(text.data(), static_cast<int>(text.size()), MPI_CHAR, rank, 0, MPI_COMM_WORLD);
}

std::optional<Message> received() {
  int has_come = 0;
  MPI_Status status;
  MPI_Iprobe(MPI_ANY_SOURCE, 0, MPI_COMM_WORLD, &has_come, &status);
  if (has_come == 0) return std::nullopt;
  int size = 0;
  MPI_Get_count(&status, MPI_CHAR, &size);
  Message message{status.MPI_SOURCE, std::string(static_cast<std::size_t>(size), '\0')};
  MPI_Recv(message.text.data(), size, MPI_CHAR, message.from, 0, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
  return message;
}

}  // namespace darwinop::gap
