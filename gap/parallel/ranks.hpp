// The processes of one `mpirun -n N darwinop gap …`. Without mpirun there is one, and MPI is not used.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace darwinop::gap {

/// Constructed in main() before any thread: joins the other ranks; its destructor leaves them.
class Ranks {
 public:
  Ranks();
  ~Ranks();
  Ranks(const Ranks&) = delete;
  Ranks& operator=(const Ranks&) = delete;

  static int own();    // the first is 0
  static int count();  // 1 without mpirun
  static bool isFirst() { return own() == 0; }
  /// Cores of this rank, counting that others may have been given the same ones.
  static unsigned cores();

  /// Ends all ranks with `code` after a failure of this one. Returns it if there is only one.
  static int giveUp(int code);
};

/// Work shared among all ranks and their threads: work(i, row) fills the `width` numbers of row i.
/// Returns all rows, one after the other: the same on every rank, and for any number of them.
///
/// Every rank must reach the call with the same arguments, since each waits for the others. Called from a thread other
/// than that of Ranks it shares nothing: ranks that work on different cases do not wait for each other.
std::vector<double> sharedRows(std::size_t count, std::size_t width,
                               const std::function<void(std::size_t, std::span<double>)>& work);

/// Sends to one rank; returns the oldest message received from any. Only from the thread of Ranks.
struct Message {
  int from = 0;
  std::string text;
};
void sendTo(int rank, const std::string& text);
std::optional<Message> received();

}  // namespace darwinop::gap
