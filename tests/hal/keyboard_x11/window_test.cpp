// Keyboard window on a real X server, with keys pressed by xdotool.
#include <gmock/gmock.h>
#include <xcb/xcb.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdlib>
#include <functional>
#include <iterator>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "connect/keys.hpp"
#include "hal/keyboard_x11/key_map.hpp"
#include "support/shell.hpp"
#include "support/x_server.hpp"

namespace darwinop::connect {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

class KeyWindowTest : public testing::Test {
 protected:
  KeyWindowTest() {
    keys = openKeys({.from = "window",
                     .display = server.name(),
                     .log =
                         [this](const std::string& what) {
                           const std::lock_guard lock{mutex};
                           log += what + "\n";
                         }},
                    ending);
    // An otherwise unused key: its arrival shows that the window has the focus.
    EXPECT_TRUE(eventually([this] {
      tool("key F9");
      return !keys->take().empty();
    })) << "no window: "
        << stderrText();
    EXPECT_TRUE(eventually([this] { return keys->take().empty(); }));
  }

  [[nodiscard]] static bool eventually(const std::function<bool()>& is_so) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds{20};
    while (!is_so()) {
      if (std::chrono::steady_clock::now() > end) return false;
      std::this_thread::sleep_for(std::chrono::milliseconds{2});
    }
    return true;
  }
  void tool(const std::string& words) const {
    const std::string command = "DISPLAY=" + server.name() + " xdotool " + words + " >/dev/null";
    EXPECT_EQ(shell(command).status, 0) << command;
  }
  /// Held keys after all events have arrived.
  [[nodiscard]] std::vector<Key> held(const std::vector<Key>& expected) {
    std::vector<Key> now;
    static_cast<void>(eventually([&] {
      now = keys->take();
      std::ranges::sort(now);
      return now == expected;
    }));
    return now;
  }
  std::string stderrText() {
    const std::lock_guard lock{mutex};
    return log;
  }

  XServer server;
  std::atomic<bool> ending{false};
  std::mutex mutex;
  std::string log;
  std::unique_ptr<KeySource> keys;
};

TEST_F(KeyWindowTest, ReturnsKeysHeldTogetherWithTheirModifiers) {
  tool("keydown Up keydown space keydown a");
  EXPECT_THAT(held({' ', 'A', kKeyUp}), ElementsAre(' ', 'A', kKeyUp));
  EXPECT_THAT(keys->take(), ElementsAre(kKeyUp, ' ', 'A')) << "again in the next step, in the order of pressing";
  tool("keyup Up keyup space keydown shift");
  EXPECT_THAT(held({'A' | kKeyShift}), ElementsAre('A' | kKeyShift));
  tool("keyup shift");
  EXPECT_THAT(held({'A'}), ElementsAre('A'));
  tool("keyup a");
  EXPECT_THAT(held({}), IsEmpty());
  // Pressed and released before the next call.
  tool("key F1 key ctrl+alt+x");
  std::vector<Key> all;
  EXPECT_TRUE(eventually([&] {
    std::ranges::copy(keys->take(), std::back_inserter(all));
    return all.size() == 2;
  }));
  EXPECT_THAT(all, ElementsAre(kKeyF1, 'X' | kKeyControl | kKeyAlt));
  if (const char* const keep = std::getenv("DARWINOP_KEEP_SHOT")) {
    tool("keydown Up keydown shift keydown a");
    std::this_thread::sleep_for(std::chrono::milliseconds{300});
    const std::string command =
        "ffmpeg -y -loglevel error -f x11grab -video_size 800x600 -i " + server.name() + " -frames:v 1 " + keep;
    EXPECT_EQ(shell(command).status, 0);
    tool("keyup Up keyup shift keyup a");
  }
}

/// During auto-repeat the server reports release and press although the key stays down.
TEST_F(KeyWindowTest, AHeldKeyStaysHeldDuringAutoRepeat) {
  tool("keydown Left");
  EXPECT_THAT(held({kKeyLeft}), ElementsAre(kKeyLeft));
  xcb_connection_t* const other = xcb_connect(server.name().c_str(), nullptr);
  xcb_query_keymap_reply_t* const map = xcb_query_keymap_reply(other, xcb_query_keymap(other), nullptr);
  xcb_get_input_focus_reply_t* const focus = xcb_get_input_focus_reply(other, xcb_get_input_focus(other), nullptr);
  xcb_key_release_event_t release{};
  release.response_type = XCB_KEY_RELEASE;
  while ((map->keys[release.detail / 8U] & (1U << (release.detail % 8U))) == 0) ++release.detail;
  xcb_send_event(other, 0, focus->focus, 0, reinterpret_cast<const char*>(&release));
  std::free(xcb_get_input_focus_reply(other, xcb_get_input_focus(other), nullptr));  // has been sent by now
  std::free(map);
  std::free(focus);
  xcb_disconnect(other);
  tool("keydown F9");
  EXPECT_THAT(held({kKeyLeft, kKeyF1 + 8}), ElementsAre(kKeyLeft, kKeyF1 + 8));
  tool("keyup Left keyup F9");
  EXPECT_THAT(held({}), IsEmpty());
}

TEST_F(KeyWindowTest, WithoutTheFocusNoKeyIsHeld) {
  tool("keydown Up");
  EXPECT_THAT(held({kKeyUp}), ElementsAre(kKeyUp));
  xcb_connection_t* const other = xcb_connect(server.name().c_str(), nullptr);
  const xcb_window_t root = xcb_setup_roots_iterator(xcb_get_setup(other)).data->root;
  xcb_set_input_focus(other, XCB_INPUT_FOCUS_NONE, root, XCB_CURRENT_TIME);
  xcb_flush(other);
  EXPECT_THAT(held({}), IsEmpty());
  tool("key F2");
  tool("mousemove 20 20 click 1");  // into the window: gives it the focus
  EXPECT_TRUE(eventually([this] {
    tool("key F3");
    const auto now = keys->take();
    EXPECT_EQ(std::ranges::count(now, kKeyF1 + 1), 0);
    return std::ranges::count(now, kKeyF1 + 2) == 1;
  }));
  xcb_disconnect(other);
}

TEST_F(KeyWindowTest, AClosedWindowIsReportedAndTheControllerContinues) {
  tool("keydown Up");
  EXPECT_THAT(held({kKeyUp}), ElementsAre(kKeyUp));
  tool("search --name 'keys for the robot' windowclose");
  EXPECT_TRUE(eventually([this] { return stderrText().find(kKeyWindowClosed) != std::string::npos; }));
  EXPECT_THAT(held({}), IsEmpty());
}

TEST_F(KeyWindowTest, AStalledNetworkReleasesAllKeys) {
  tool("keydown Up");
  EXPECT_THAT(held({kKeyUp}), ElementsAre(kKeyUp));
  std::this_thread::sleep_for(std::chrono::milliseconds{1100});  // two polls
  EXPECT_THAT(keys->take(), ElementsAre(kKeyUp)) << "the server still reports the key as down";
  server.hang();
  EXPECT_THAT(held({}), IsEmpty());
}

/// A network that stalls after the event of a release: the question whether the key is down has no answer.
TEST(KeyMap, AServerThatDoesNotAnswerIsNotWaitedFor) {
  XServer server;
  xcb_connection_t* const connection = xcb_connect(server.name().c_str(), nullptr);
  ASSERT_EQ(x11::isDown(connection, 40), false);
  server.hang();
  EXPECT_EQ(x11::isDown(connection, 40), std::nullopt);
  xcb_disconnect(connection);
}

TEST_F(KeyWindowTest, ADeadServerIsReportedAndTheControllerContinues) {
  tool("keydown Up");
  EXPECT_THAT(held({kKeyUp}), ElementsAre(kKeyUp));
  server.end();
  EXPECT_TRUE(eventually([this] { return stderrText().find(kKeyServerGone) != std::string::npos; }));
  EXPECT_THAT(held({}), IsEmpty());
}

}  // namespace
}  // namespace darwinop::connect
