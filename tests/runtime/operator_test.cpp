// `darwinop runtime --status`: text that another process wrote.
#include "runtime/operator.hpp"

#include <gmock/gmock.h>

#include "runtime/exchange.hpp"
#include "runtime/file_lock.hpp"
#include "support/temporary_folder.hpp"

namespace darwinop::runtime {
namespace {

using testing::HasSubstr;

TEST(DaemonStatus, EscapesRobotAndPort) {
  const TemporaryFolder folder;
  const RuntimeFiles files{folder / "runtime"};
  const Exchange host = Exchange::create(files.exchange);
  const auto loop = FileLock::tryTake(files.loop_lock);
  LoopInfo& info = host.ownBlock().info;
  setText(info.robot, sizeof info.robot, "\x1b[2Jrobot");
  setText(info.port, sizeof info.port, "/dev/\x1b]0;port\x07");
  const std::string shown = daemonStatus(files);
  EXPECT_THAT(shown, HasSubstr("\\x1b[2Jrobot on /dev/\\x1b]0;port\\x07\n"));
  EXPECT_THAT(shown, testing::Not(HasSubstr("\x1b")));
}

}  // namespace
}  // namespace darwinop::runtime
