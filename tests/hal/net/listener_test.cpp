// No other program can bind the server's port, with or without a connected client.
#include "hal/net/listener.hpp"

#include <gtest/gtest.h>
#include <netinet/in.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>

#include "remote/server/visits.hpp"

namespace darwinop::remote {
namespace {

using namespace std::chrono_literals;

constexpr uid_t kNobody = 65534;
constexpr std::array kAddresses{INADDR_LOOPBACK, INADDR_ANY};

/// Socket options that the other program sets before bind().
struct Claim {
  bool reuse_address = false, reuse_port = false;
};
constexpr std::array kClaims{Claim{}, Claim{.reuse_address = true}, Claim{.reuse_port = true}, Claim{true, true}};

/// 0: the port was taken, so connections would arrive here. Otherwise the errno of the call that failed.
int take(std::uint16_t port, in_addr_t address, Claim claim) {
  const net::Socket socket{::socket(AF_INET, SOCK_STREAM, 0)};
  const int on = 1;
  if (claim.reuse_address) (void)setsockopt(socket.descriptor(), SOL_SOCKET, SO_REUSEADDR, &on, sizeof on);
  if (claim.reuse_port) (void)setsockopt(socket.descriptor(), SOL_SOCKET, SO_REUSEPORT, &on, sizeof on);
  sockaddr_in name{};
  name.sin_family = AF_INET;
  name.sin_port = htons(port);
  name.sin_addr.s_addr = htonl(address);
  if (bind(socket.descriptor(), reinterpret_cast<const sockaddr*>(&name), sizeof name) != 0) return errno;
  return listen(socket.descriptor(), 4) == 0 ? 0 : errno;
}

/// Runs in a forked process of another user, with system calls only. Its exit code is the result.
template <class Action>
pid_t asNobody(Action action) {
  const pid_t child = fork();
  if (child != 0) return child;
  for (int inherited = 3; inherited < 256; ++inherited) (void)close(inherited);  // the server's sockets among them
  if (setgid(kNobody) != 0 || setuid(kNobody) != 0 || prctl(PR_SET_PDEATHSIG, SIGKILL) != 0) _exit(255);
  _exit(action());
}

int exitCode(pid_t child) {
  int status = 0;
  return waitpid(child, &status, 0) == child && WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

/// A process of another user that is killed at the end.
class Thief {
 public:
  template <class Action>
  explicit Thief(Action action) : pid_{asNobody(action)} {}
  ~Thief() {
    if (ended_) return;
    (void)kill(pid_, SIGKILL);
    (void)waitpid(pid_, nullptr, 0);
  }
  Thief(const Thief&) = delete;
  Thief& operator=(const Thief&) = delete;

  [[nodiscard]] bool ended() { return ended_ = ended_ || waitpid(pid_, nullptr, WNOHANG) == pid_; }

 private:
  pid_t pid_;
  bool ended_ = false;
};

/// Tries every address and option as another user.
void expectPortKept(const Served& served, const char* when) {
  for (const in_addr_t address : kAddresses)
    for (const Claim claim : kClaims)
      EXPECT_EQ(exitCode(asNobody([&] { return take(served.server.port(), address, claim); })), EADDRINUSE)
          << when << ", address " << address << ", SO_REUSEADDR " << claim.reuse_address << ", SO_REUSEPORT "
          << claim.reuse_port;
}

class RemotePort : public testing::Test {
 protected:
  void SetUp() override {
    if (geteuid() != 0)
      GTEST_SKIP() << "NOT TESTED: another user takes the port. Only root can become another user; run this as root";
  }
};

TEST_F(RemotePort, CannotBeBoundByAnotherUser) {
  Served served;
  expectPortKept(served, "no client has connected");
  TestClient driver{served};
  expectPortKept(served, "a client has connected");
  (void)driver.ask(kEmptyRequest);
  expectPortKept(served, "a client drives");
  EXPECT_FALSE(TestClient{served}.connected());
  expectPortKept(served, "another client was refused");
  served.pass(500ms);
  expectPortKept(served, "the client is silent");
  (void)driver.ask(kEmptyRequest);
  expectPortKept(served, "the client drives on");
  driver.close();
  expectPortKept(served, "the client has disconnected");
  TestClient next{served};
  (void)next.ask(kEmptyRequest);
  expectPortKept(served, "the next client drives");
  next.reset();
  expectPortKept(served, "the next client has reset the connection");
  served.robot.refusal = "another controller drives this robot";
  (void)TestClient{served}.ask(kEmptyRequest);
  expectPortKept(served, "a client was disconnected");
}

TEST_F(RemotePort, CannotBeBoundBetweenTwoClients) {
  Served served;
  Thief thief{[port = served.server.port()]() -> int {
    for (;;)
      for (const in_addr_t address : kAddresses)
        for (const Claim claim : kClaims)
          if (take(port, address, claim) == 0) return 0;
  }};
  for (int i = 0; i < 1000 && !thief.ended(); ++i)
    (void)nextIsAnswered(served);  // the kernel is busy: not every client is answered
  EXPECT_FALSE(thief.ended()) << "another user has got the port";
  EXPECT_FALSE(served.hasSaid(net::kCannotListen));
  EXPECT_GT(served.robot.applied.size(), 0);
}

TEST(RemoteServer, KeepsItsPortFromProgramsOfItsOwnUser) {
  Served served;
  TestClient driver{served};
  for (const char* const when : {"a client is connected", "no client is connected"}) {
    for (const in_addr_t address : kAddresses)
      for (const Claim claim : {Claim{}, Claim{.reuse_address = true}})
        EXPECT_EQ(take(served.server.port(), address, claim), EADDRINUSE) << when;
    driver.close();
  }
}

// A connection in TIME_WAIT must not keep a restarted server from its port.
TEST(RemoteServer, ReopensItsPortAtOnceAfterARestart) {
  std::uint16_t port = 0;
  for (int i = 0; i < 3; ++i) {
    Served served{{}, Served::unhurried(), port};
    port = served.server.port();
    served.robot.must_end = "torque was switched off by the button";
    TestClient client{served};
    client.send(kEmptyRequest);
    EXPECT_TRUE(client.shownOut()) << "the server ends the connection, so the TIME_WAIT state is on its side";
  }
}

}  // namespace
}  // namespace darwinop::remote
