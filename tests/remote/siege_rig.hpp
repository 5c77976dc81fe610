// What an attack meets in earnest: a virtual robot on a pty, the daemon that drives it, the server of remote control,
// each a process of its own; and a client that drives.
#pragma once

#include <arpa/inet.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/socket.h>
#include <time.h>

#include <fstream>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "hal/net/socket.hpp"
#include "runtime/operator.hpp"
#include "support/temporary_folder.hpp"
#include "system/program.hpp"

namespace darwinop::remote {

class SiegeRig {
 public:
  /// `programs`: their folder. `before_runtime`: a command that starts another one, such as setpriv. `server_config`:
  /// text of the server's config.ini; empty: it has none.
  explicit SiegeRig(const std::string& programs, std::vector<std::string> before_runtime = {},
                    const std::string& server_config = {})
      : robot_{{programs + "/darwinop-virtual-robot", "--link", folder_ / "port"}, folder_ / "robot.txt"} {
    mustSay(robot_, "link:");
    before_runtime.insert(before_runtime.end(), {programs + "/darwinop-runtime", "--robot", folder_ / "port", "--name",
                                                 folder_ / "runtime", "--period", "16"});
    runtime_.emplace(before_runtime, folder_ / "runtime.txt");
    mustSay(*runtime_, "ready:");
    setenv("DARWINOP_RUNTIME_NAME", (folder_ / "runtime").c_str(), 1);  // for the server
    std::vector<std::string> server{programs + "/darwinop-remote", "--port", "0"};
    if (!server_config.empty()) {
      std::ofstream{folder_ / "config.ini"} << server_config;
      server.insert(server.end(), {"--config", folder_ / "config.ini"});
    }
    server_.emplace(server, folder_ / "server.txt");
    const std::string ready = "ready: 127.0.0.1:";
    mustSay(*server_, ready);
    const std::string said = server_->output();
    port_ = static_cast<std::uint16_t>(std::stoi(said.substr(said.find(ready) + ready.size())));
    exchange_.emplace(runtime::attachToDaemon(runtime::RuntimeFiles{folder_ / "runtime"}));
  }

  [[nodiscard]] std::uint16_t port() const { return port_; }
  [[nodiscard]] Program& server() { return *server_; }
  [[nodiscard]] const Program& runtime() const { return *runtime_; }
  [[nodiscard]] runtime::StatsView stats() const {
    runtime::StatsView view;
    exchange_->block().stats.copyTo(view);
    return view;
  }
  /// Until the loop has run that many more cycles. False: it has not within a minute.
  [[nodiscard]] bool runCycles(std::uint32_t count) const {
    const std::uint32_t end = exchange_->block().stats.cycles() + count;
    for (int i = 0; i < 6000; ++i) {
      if (exchange_->block().stats.cycles() >= end) return true;
      std::this_thread::sleep_for(std::chrono::milliseconds{10});
    }
    return false;
  }
  /// CPU time that the server's process has taken.
  [[nodiscard]] std::chrono::duration<double> serverCpu() const {
    clockid_t clock{};
    timespec taken{};
    if (clock_getcpuclockid(server_->pid(), &clock) != 0 || clock_gettime(clock, &taken) != 0)
      throw std::runtime_error("the server has ended: " + server_->output());
    return std::chrono::seconds{taken.tv_sec} + std::chrono::nanoseconds{taken.tv_nsec};
  }
  /// Memory of the server's process, kB.
  [[nodiscard]] long residentKb() const {
    std::ifstream status{"/proc/" + std::to_string(server_->pid()) + "/status"};
    for (std::string word; status >> word;)
      if (word == "VmRSS:" && status >> word) return std::stol(word);
    throw std::runtime_error("the server has ended: " + server_->output());
  }

 private:
  static void mustSay(const Program& program, const std::string& text) {
    if (!program.says(text, std::chrono::seconds{30}))
      throw std::runtime_error("no '" + text + "': " + program.output());
  }

  TemporaryFolder folder_;
  Program robot_;
  std::optional<Program> runtime_, server_;
  std::optional<runtime::Exchange> exchange_;
  std::uint16_t port_ = 0;
};

/// Asks and waits for the answer, 5 s at most.
class SiegeClient {
 public:
  explicit SiegeClient(std::uint16_t port) : socket_{::socket(AF_INET, SOCK_STREAM, 0)} {
    const timeval patience{5, 0};
    (void)setsockopt(socket_.descriptor(), SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof patience);
    const int on = 1;
    (void)setsockopt(socket_.descriptor(), IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
    sockaddr_in name{};
    name.sin_family = AF_INET;
    name.sin_port = htons(port);
    name.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    if (connect(socket_.descriptor(), reinterpret_cast<const sockaddr*>(&name), sizeof name) != 0) socket_.close();
  }
  /// An empty request. False: no whole answer came.
  [[nodiscard]] bool ask() const {
    if (!socket_.open()) return false;
    const unsigned char request[] = {'W', 4, 0, 0};
    unsigned char reply[6];
    return send(socket_.descriptor(), request, sizeof request, MSG_NOSIGNAL) == sizeof request &&
           recv(socket_.descriptor(), reply, sizeof reply, MSG_WAITALL) == sizeof reply;
  }

 private:
  net::Socket socket_;
};

}  // namespace darwinop::remote
