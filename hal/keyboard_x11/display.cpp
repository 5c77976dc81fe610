#include "hal/keyboard_x11/display.hpp"

#include <X11/Xauth.h>
#include <arpa/inet.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <charconv>
#include <cstddef>
#include <cstring>
#include <stdexcept>
#include <string_view>
#include <utility>

namespace darwinop::x11 {
namespace {

[[noreturn]] void noServer(const std::string& why) {
  throw std::runtime_error(why);
}

/// Parses and removes the digits at the start of `text`.
int numberIn(std::string_view& text, const std::string& whole) {
  int number = -1;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc{} || number < 0 || number > 9999)
    noServer("DISPLAY=" + whole + " is not a display name; expected :0 or localhost:10.0");
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  return number;
}

struct Socket {
  explicit Socket(int family, int flags = 0) : fd{::socket(family, SOCK_STREAM | SOCK_CLOEXEC | flags, 0)} {}
  ~Socket() {
    if (fd >= 0) ::close(fd);
  }
  Socket(const Socket&) = delete;
  Socket& operator=(const Socket&) = delete;
  int release() { return std::exchange(fd, -1); }
  int fd;
};

/// Returns the socket, or -1 and errno. `abstract`: Linux's abstract namespace, which X servers also use.
int connectHere(int number, bool abstract) {
  Socket socket{AF_UNIX};
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  std::string name = "/tmp/.X11-unix/X" + std::to_string(number);
  if (abstract) name.insert(0, 1, '\0');
  std::memcpy(static_cast<char*>(address.sun_path), name.data(), name.size());
  const auto size = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + name.size() + (abstract ? 0 : 1));
  if (socket.fd < 0 || ::connect(socket.fd, reinterpret_cast<const sockaddr*>(&address), size) != 0) return -1;
  return socket.release();
}

/// Returns the socket, or -1 and errno.
int connectOverTcp(in_addr host, int number) {
  constexpr int kFirstPort = 6000, kPatienceMs = 3000;
  Socket socket{AF_INET, SOCK_NONBLOCK};
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(static_cast<std::uint16_t>(kFirstPort + number));
  address.sin_addr = host;
  if (socket.fd < 0) return -1;
  if (::connect(socket.fd, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0) {
    if (errno != EINPROGRESS) return -1;
    pollfd ready{socket.fd, POLLOUT, 0};
    int error = ETIMEDOUT;
    socklen_t size = sizeof error;
    if (::poll(&ready, 1, kPatienceMs) == 1) ::getsockopt(socket.fd, SOL_SOCKET, SO_ERROR, &error, &size);
    errno = error;
    if (error != 0) return -1;
  }
  return socket.release();
}

/// The cookie from ~/.Xauthority or the file named by XAUTHORITY. Servers reached through this computer (also by ssh)
/// are listed under its own host name.
struct Cookie {
  explicit Cookie(int display) {
    constexpr unsigned short kFamilyLocal = 256;
    std::array<char, 256> host{};
    if (::gethostname(host.data(), host.size() - 1) != 0) return;
    const std::string number = std::to_string(display);
    std::string kind = "MIT-MAGIC-COOKIE-1";
    std::array<char*, 1> kinds{kind.data()};
    std::array<int, 1> lengths{static_cast<int>(kind.size())};
    found = ::XauGetBestAuthByAddr(kFamilyLocal, static_cast<unsigned short>(std::strlen(host.data())), host.data(),
                                   static_cast<unsigned short>(number.size()), number.data(), 1, kinds.data(),
                                   lengths.data());
  }
  ~Cookie() {
    if (found != nullptr) ::XauDisposeAuth(found);
  }
  Cookie(const Cookie&) = delete;
  Cookie& operator=(const Cookie&) = delete;
  [[nodiscard]] xcb_auth_info_t info() const {
    if (found == nullptr) return {};
    return {found->name_length, found->name, found->data_length, found->data};
  }
  Xauth* found = nullptr;
};

int openSocket(const DisplayName& display, const std::string& name) {
  int fd = -1;
  if (display.host.empty() || display.host == "unix") {
    fd = connectHere(display.number, true);
    if (fd < 0) fd = connectHere(display.number, false);
  } else {
    in_addr host{};
    const std::string number = display.host == "localhost" ? "127.0.0.1" : display.host;
    if (::inet_pton(AF_INET, number.c_str(), &host) != 1)
      noServer("DISPLAY=" + name + ": host names are not resolved; use the IP address of " + display.host);
    fd = connectOverTcp(host, display.number);
  }
  if (fd < 0) noServer("cannot connect to the X server at DISPLAY=" + name + " (" + std::strerror(errno) + ")");
  return fd;
}

}  // namespace

DisplayName parseDisplay(const std::string& text) {
  if (text.empty()) noServer(kDisplayNotSet);
  DisplayName display;
  const auto colon = text.rfind(':');
  if (colon == std::string::npos) noServer("DISPLAY=" + text + " is not a display name; expected :0 or localhost:10.0");
  display.host = text.substr(0, colon);
  std::string_view rest = std::string_view{text}.substr(colon + 1);
  display.number = numberIn(rest, text);
  if (rest.starts_with('.')) {
    rest.remove_prefix(1);
    display.screen = numberIn(rest, text);
  }
  if (!rest.empty()) noServer("DISPLAY=" + text + " is not a display name; expected :0 or localhost:10.0");
  return display;
}

Connection connectTo(const DisplayName& display) {
  const std::string name = display.host + ":" + std::to_string(display.number);
  const int fd = openSocket(display, name);
  const Cookie cookie{display.number};
  xcb_auth_info_t shown = cookie.info();
  Connection connection{::xcb_connect_to_fd(fd, &shown)};  // takes ownership of the socket
  if (::xcb_connection_has_error(connection.get()) != 0)
    noServer(
        "the X server at DISPLAY=" + name +
        " denied access: it belongs to another user. Run `xhost +si:localuser:$(id -un)` there, or set XAUTHORITY");
  return connection;
}

}  // namespace darwinop::x11
