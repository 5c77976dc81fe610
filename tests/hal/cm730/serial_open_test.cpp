// Opening ports: settings, exclusive access, rediscovery, error messages.
#include "hal/cm730/serial_open.hpp"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/file.h>
#include <sys/prctl.h>
#include <sys/stat.h>
#include <termios.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <optional>

#include "hal/cm730/diagnosis/port_check.hpp"
#include "hal/cm730/port_messages.hpp"
#include "hal/cm730/pty.hpp"
#include "hal/fork_guard.hpp"
#include "runtime/child.hpp"
#include "support/text_of.hpp"

namespace darwinop::cm730 {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;
using Step = OpenAttempt::Step;

class OpenFile {
 public:
  explicit OpenFile(int fd) : fd_{fd} {}
  ~OpenFile() { closeSerial(fd_); }
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;
  [[nodiscard]] int get() const { return fd_; }

 private:
  int fd_;
};

TEST(OpenSerial, ConfiguresAPtyAsRawOneMegabaudNonBlocking) {
  const Pty pty;
  const OpenFile port{openSerial(pty.path()).fd};
  ASSERT_GE(port.get(), 0);
  termios settings{};
  ASSERT_EQ(::tcgetattr(port.get(), &settings), 0);
  EXPECT_EQ(::cfgetospeed(&settings), static_cast<speed_t>(B1000000));
  EXPECT_EQ(settings.c_lflag & (ICANON | ECHO | ISIG), 0u);
  EXPECT_EQ(settings.c_oflag & OPOST, 0u);
  EXPECT_EQ(settings.c_cc[VMIN], 0);
  EXPECT_EQ(settings.c_cc[VTIME], 0);
  std::uint8_t byte = 0;
  EXPECT_EQ(::read(port.get(), &byte, 1), 0) << "read() without data must return 0 at once";
}

struct Flag {
  const char* name;
  tcflag_t termios::*field;
  tcflag_t bit;
};
// Flags that a previous owner of the port may have set.
constexpr Flag kLeftBehind[] = {
    {"IGNBRK", &termios::c_iflag, IGNBRK},   {"BRKINT", &termios::c_iflag, BRKINT},
    {"IGNPAR", &termios::c_iflag, IGNPAR},   {"PARMRK", &termios::c_iflag, PARMRK},
    {"INPCK", &termios::c_iflag, INPCK},     {"ISTRIP", &termios::c_iflag, ISTRIP},
    {"INLCR", &termios::c_iflag, INLCR},     {"IGNCR", &termios::c_iflag, IGNCR},
    {"ICRNL", &termios::c_iflag, ICRNL},     {"IUCLC", &termios::c_iflag, IUCLC},
    {"IXON", &termios::c_iflag, IXON},       {"IXANY", &termios::c_iflag, IXANY},
    {"IXOFF", &termios::c_iflag, IXOFF},     {"IMAXBEL", &termios::c_iflag, IMAXBEL},
    {"IUTF8", &termios::c_iflag, IUTF8},     {"OPOST", &termios::c_oflag, OPOST},
    {"ONLCR", &termios::c_oflag, ONLCR},     {"OCRNL", &termios::c_oflag, OCRNL},
    {"OFILL", &termios::c_oflag, OFILL},     {"CSTOPB", &termios::c_cflag, CSTOPB},
    {"PARODD", &termios::c_cflag, PARODD},   {"HUPCL", &termios::c_cflag, HUPCL},
    {"CRTSCTS", &termios::c_cflag, CRTSCTS}, {"CMSPAR", &termios::c_cflag, CMSPAR},
    {"ISIG", &termios::c_lflag, ISIG},       {"ICANON", &termios::c_lflag, ICANON},
    {"ECHO", &termios::c_lflag, ECHO},       {"ECHONL", &termios::c_lflag, ECHONL},
    {"NOFLSH", &termios::c_lflag, NOFLSH},   {"TOSTOP", &termios::c_lflag, TOSTOP},
    {"IEXTEN", &termios::c_lflag, IEXTEN},   {"EXTPROC", &termios::c_lflag, EXTPROC},
};

TEST(OpenSerial, ClearsEveryFlagOfThePreviousOwner) {
  for (const Flag& flag : kLeftBehind) {
    const Pty pty;
    const int former = ::open(pty.path().c_str(), O_RDWR | O_NOCTTY);
    ASSERT_GE(former, 0);
    termios settings{};
    ASSERT_EQ(::tcgetattr(former, &settings), 0);
    settings.*flag.field |= flag.bit;
    ASSERT_EQ(::tcsetattr(former, TCSANOW, &settings), 0) << flag.name;
    ASSERT_EQ(::tcgetattr(former, &settings), 0);
    ASSERT_EQ(settings.*flag.field & flag.bit, flag.bit) << flag.name << " cannot be set on a pty: remove it here";
    ::close(former);

    const OpenFile port{openSerial(pty.path()).fd};
    ASSERT_GE(port.get(), 0) << flag.name;
    ASSERT_EQ(::tcgetattr(port.get(), &settings), 0);
    for (const Flag& other : kLeftBehind)
      EXPECT_EQ(settings.*other.field & other.bit, 0u) << other.name << " after " << flag.name;
    EXPECT_EQ(settings.c_iflag | settings.c_oflag | settings.c_lflag, 0u) << flag.name;
    EXPECT_EQ(settings.c_cflag & (CSIZE | CREAD | CLOCAL), static_cast<tcflag_t>(CS8 | CREAD | CLOCAL)) << flag.name;
  }
}

TEST(OpenSerial, RejectsAPortInUseAndNamesTheProcess) {
  const Pty pty;
  const OpenFile first{openSerial(pty.path()).fd};
  ASSERT_GE(first.get(), 0);
  const OpenAttempt second = openSerial(pty.path());
  EXPECT_EQ(second.fd, -1);
  EXPECT_EQ(second.step, Step::kLock);
  EXPECT_THAT(explain(pty.path(), second), HasSubstr(pty.path() + kPortInUse + "this "));
}

TEST(OpenSerial, NamesTheProcessWithTheLockAndNotAnotherThatHasThePortOpen) {
  const Pty pty;
  const OpenFile without_lock{::open(pty.path().c_str(), O_RDWR | O_NOCTTY | O_CLOEXEC)};
  const runtime::Child other{[&] { (void)openSerial(pty.path()); }};
  EXPECT_THAT(explain(pty.path(), openSerial(pty.path())),
              HasSubstr(kPortInUse + ("process " + std::to_string(other.pid())) + " "));
}

TEST(OpenSerial, EscapesTheNameThatTheProcessAtThePortGaveItself) {
  const TemporaryFolder folder;
  const runtime::Child other{[&] {
    prctl(PR_SET_NAME, "\x1b[2Jfree");
    static const Pty pty;  // not in this process, which would be named
    (void)openSerial(pty.path());
    std::ofstream{folder / "path"} << pty.path();
  }};
  const std::string path = textOf(folder / "path");
  const std::string said = explain(path, openSerial(path));
  EXPECT_THAT(said, HasSubstr(std::to_string(other.pid()) + " (\\x1b[2Jfree)"));
  EXPECT_THAT(said, testing::Not(HasSubstr("\x1b")));
}

/// As Python's multiprocessing does. The name of a process that has ended would be that of any other.
TEST(OpenSerial, AForkedProcessDoesNotKeepThePort) {
  const Pty pty;
  const TemporaryFolder folder;
  runtime::Child other{[&] {
    (void)openSerial(pty.path());
    static const runtime::Child sleeper{[] {}};
    std::ofstream{folder / "sleeper"} << sleeper.pid();
  }};
  EXPECT_EQ(openSerial(pty.path()).fd, -1) << "still in use";
  other.kill(SIGKILL);
  const OpenFile port{openSerial(pty.path()).fd};
  EXPECT_GE(port.get(), 0);
  ::kill(std::stoi(textOf(folder / "sleeper")), SIGKILL);
}

TEST(OpenSerial, NamesAProcessThatLivesIfTheOneWithTheLockHasEnded) {
  const Pty pty;
  const TemporaryFolder folder;
  runtime::Child other{[&] {
    const int fd = ::open(pty.path().c_str(), O_RDWR | O_NOCTTY | O_CLOEXEC);
    if (::flock(fd, LOCK_EX) != 0) ::_exit(1);
    static const runtime::Child sleeper{[] {}};
    std::ofstream{folder / "sleeper"} << sleeper.pid();
  }};
  const std::string ended = std::to_string(other.pid());
  other.kill(SIGKILL);
  EXPECT_THAT(explain(pty.path(), openSerial(pty.path())),
              AllOf(HasSubstr(kPortInUse), testing::Not(HasSubstr("process " + ended))));
  ::kill(std::stoi(textOf(folder / "sleeper")), SIGKILL);
}

TEST(OpenSerial, APortThatIsRequiredStaysFree) {
  const Pty pty;
  requirePort(pty.path());
  const OpenFile port{openSerial(pty.path()).fd};
  EXPECT_GE(port.get(), 0);
  EXPECT_THROW(requirePort(pty.path()), std::runtime_error) << "in use";
}

TEST(OpenSerial, SaysHowToStopTheRuntimeWhoseNameTheKernelCutsAt15Letters) {
  const Pty pty;
  const runtime::Child other{[&] {
    prctl(PR_SET_NAME, "darwinop-runtime");
    (void)openSerial(pty.path());
  }};
  const std::string pid = std::to_string(other.pid());
  EXPECT_EQ(explain(pty.path(), openSerial(pty.path())), pty.path() + kPortInUse + "process " + pid +
                                                             " (darwinop-runtime): " + howToStopRuntime(pid) +
                                                             kDriveThroughRuntime);
  EXPECT_THAT(howToStopRuntime("7"), HasSubstr("`kill 7`"));
}

TEST(OpenSerial, DoesNotChangeAPortInUse) {
  Pty pty;
  const OpenFile first{openSerial(pty.path()).fd};
  const std::uint8_t byte = 7;
  send(pty, {&byte, 1});
  EXPECT_EQ(openSerial(pty.path()).fd, -1);
  std::uint8_t got = 0;
  EXPECT_EQ(::read(first.get(), &got, 1), 1) << "the second open() discarded the first one's bytes";
}

TEST(OpenSerial, ReportsFilesThatAreNotSerialPorts) {
  const TemporaryFolder folder;
  const std::string file = folder / "file";
  std::ofstream{file} << "text";
  for (const std::string& path : {std::string{"/dev/null"}, file, folder / ""}) {
    const OpenAttempt attempt = openSerial(path);
    EXPECT_EQ(attempt.fd, -1);
    EXPECT_THAT(explain(path, attempt), HasSubstr(path + kNotASerialPort));
  }
}

TEST(OpenSerial, ReportsAMissingPortWithARemedy) {
  const OpenAttempt attempt = openSerial("/dev/ttyNOSUCHPORT");
  EXPECT_EQ(attempt.error, ENOENT);
  EXPECT_THAT(explain("/dev/ttyNOSUCHPORT", attempt),
              AllOf(HasSubstr(std::string{"/dev/ttyNOSUCHPORT"} + kNoSuchPort),
                    testing::AnyOf(HasSubstr("virtual-robot"), HasSubstr("--robot"))));
}

TEST(OpenSerial, NamesTheGroupWhenPermissionIsMissing) {
  EXPECT_THAT(explain("/dev/ttyUSB0", {-1, Step::kOpen, EACCES}), HasSubstr("usermod -aG dialout $USER"));
}

/// Drops root privileges during its lifetime.
class OrdinaryUser {
 public:
  static bool possible() { return ::geteuid() == 0; }
  OrdinaryUser() : ok_{::seteuid(65534) == 0} {}
  ~OrdinaryUser() { EXPECT_EQ(::seteuid(0), 0); }
  OrdinaryUser(const OrdinaryUser&) = delete;
  OrdinaryUser& operator=(const OrdinaryUser&) = delete;
  [[nodiscard]] bool ok() const { return ok_; }

 private:
  bool ok_;
};

TEST(OpenSerial, IsRefusedWithoutPermission) {
  if (!OrdinaryUser::possible()) GTEST_SKIP() << "needs root";
  const Pty pty;
  ASSERT_EQ(::chmod(pty.path().c_str(), 0600), 0);
  const OrdinaryUser nobody;
  ASSERT_TRUE(nobody.ok());
  const OpenAttempt attempt = openSerial(pty.path());
  EXPECT_EQ(attempt.error, EACCES);
}

// TIOCEXCL outlives the last user of a pty whose other end stays open, such as a virtual robot's.
TEST(OpenSerial, AnUnprivilegedUserCanReopenAPtyAfterItsUserWasKilled) {
  if (!OrdinaryUser::possible()) GTEST_SKIP() << "needs root";
  const Pty pty;
  ASSERT_EQ(::chmod(pty.path().c_str(), 0666), 0);
  const OrdinaryUser nobody;
  ASSERT_TRUE(nobody.ok());
  const OpenAttempt killed = openSerial(pty.path());
  ASSERT_GE(killed.fd, 0);
  unguardFromForks(killed.fd);
  ::close(killed.fd);  // as the kernel does when the process is killed
  const OpenFile again{openSerial(pty.path()).fd};
  EXPECT_GE(again.get(), 0);
}

TEST(PortMemory, FollowsARecreatedLink) {
  const TemporaryFolder folder;
  const std::string link = folder / "robot";
  std::optional<Pty> pty{link};
  const PortMemory memory{link};
  pty.reset();
  EXPECT_EQ(memory.reopen(), -1);

  const Pty after{link};
  const OpenFile port{memory.reopen()};
  EXPECT_GE(port.get(), 0);
}

TEST(PortMemory, NeverFollowsAStaleLink) {
  const TemporaryFolder folder;
  const std::string link = folder / "robot";
  const Pty somebodys_terminal{link};
  EXPECT_EQ(PortMemory{link}.reopen(), -1);
  EXPECT_EQ(PortMemory{somebodys_terminal.path()}.reopen(), -1);
}

TEST(OpenSerial, DistinguishesTemporaryFromPermanentErrors) {
  for (const int error : {ENOENT, ENODEV, ENXIO, EBUSY, EWOULDBLOCK})
    EXPECT_TRUE(mayComeYet({-1, Step::kOpen, error})) << std::strerror(error);
  for (const int error : {EACCES, EPERM, ENOTTY, EISDIR, ENOTDIR, EINVAL, EIO})
    EXPECT_FALSE(mayComeYet({-1, Step::kOpen, error})) << std::strerror(error);
}

TEST(CheckPort, ReportsOnceWhyAPortCannotBeOpened) {
  const PortCheck check = checkPort("/dev/ttyNOSUCHPORT");
  EXPECT_EQ(check.port, nullptr);
  ASSERT_EQ(check.findings.size(), 1u);
  EXPECT_EQ(check.findings[0].level, Level::kError);
  EXPECT_TRUE(check.findings[0].is(Kind::kPortMissing));
  EXPECT_THAT(toText(check.findings[0]),
              AllOf(StartsWith("FAIL "), HasSubstr(std::string{"/dev/ttyNOSUCHPORT"} + kNoSuchPort)));
}

TEST(CheckPort, OpensAPty) {
  const Pty pty;
  const PortCheck check = checkPort(pty.path());
  EXPECT_NE(check.port, nullptr);
  EXPECT_EQ(worst(check.findings), Level::kOk);
}

TEST(LatencyRows, ContainTheCommandForATimerThatIsTooLong) {
  const Findings slow = latencyRows("/dev/ttyUSB0", 16);
  ASSERT_EQ(slow.size(), 1u);
  EXPECT_TRUE(slow[0].is(Kind::kLatencyTimer));
  EXPECT_THAT(slow[0].remedy, HasSubstr("echo 1 | sudo tee /sys/bus/usb-serial/devices/ttyUSB0/latency_timer"));
  EXPECT_EQ(worst(latencyRows("/dev/ttyUSB0", 1)), Level::kOk);
  EXPECT_TRUE(latencyRows("/dev/pts/3", std::nullopt).empty());
}

}  // namespace
}  // namespace darwinop::cm730
