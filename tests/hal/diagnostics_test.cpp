// Non-blocking diagnostics with a full pipe and with a closed one.
#include "hal/diagnostics.hpp"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <unistd.h>

#include <csignal>
#include <ostream>
#include <string>

namespace darwinop {
namespace {

using testing::HasSubstr;

struct Pipe {
  Pipe() {
    if (pipe(ends) != 0) ADD_FAILURE();
  }
  ~Pipe() {
    close(ends[0]);
    close(ends[1]);
  }
  /// The pipe's present content.
  [[nodiscard]] std::string taken() const {
    fcntl(ends[0], F_SETFL, O_NONBLOCK);
    std::string all;
    char part[4096];
    for (ssize_t count = 0; (count = read(ends[0], part, sizeof part)) > 0;)
      all.append(part, static_cast<std::size_t>(count));
    return all;
  }
  int ends[2];
};

TEST(Diagnostics, AFullPipeDropsTheRestAndReportsIt) {
  const Pipe pipe;
  NeverWaitingBuffer buffer{pipe.ends[1]};
  std::ostream out{&buffer};
  for (int i = 0; i < 20'000; ++i) out << "fault 40 controller_stalled\n";  // a blocking write would hang here
  EXPECT_GT(pipe.taken().size(), 10'000u);
  out << "fault 40 is over\n";
  const std::string later = pipe.taken();
  EXPECT_THAT(later, HasSubstr(kMessagesDropped));
  EXPECT_THAT(later, HasSubstr("fault 40 is over"));
}

TEST(Diagnostics, WritingToAClosedPipeFailsEachTime) {
  std::signal(SIGPIPE, SIG_IGN);
  const Pipe pipe;
  close(pipe.ends[0]);
  NeverWaitingBuffer buffer{pipe.ends[1]};
  std::ostream out{&buffer};
  for (int i = 0; i < 3; ++i) out << "not read\n" << std::flush;
  EXPECT_TRUE(out.good());
}

TEST(Diagnostics, LongTextsArriveWhole) {
  const Pipe pipe;
  const std::string text(30'000, 'x');
  EXPECT_TRUE(writeWithoutWaiting(pipe.ends[1], text));
  EXPECT_EQ(pipe.taken(), text);
}

}  // namespace
}  // namespace darwinop
