// Each thing is said once.
#include "hal/camera_v4l2/voice.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>
#include <vector>

namespace darwinop::v4l2 {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

struct VoiceTest : testing::Test {
  std::vector<std::string> heard;
  Voice voice{[this](const std::string& sentence) { heard.push_back(sentence); }};
};

TEST_F(VoiceTest, TellsAKindOfTroubleOnceUntilItIsOver) {
  voice.trouble(Trouble::kBusy, "busy");
  voice.trouble(Trouble::kBusy, "still busy");
  voice.trouble(Trouble::kSilent, "silent");
  voice.back("back");
  voice.back("back again");
  voice.trouble(Trouble::kBusy, "busy anew");
  EXPECT_THAT(heard, ElementsAre("busy", "silent", "back", "busy anew"));
}

TEST_F(VoiceTest, DoesNotWelcomeACameraThatWasNeverMissed) {
  voice.back("back");
  EXPECT_FALSE(voice.troubled());
  EXPECT_THAT(heard, IsEmpty());
}

TEST_F(VoiceTest, DoesNotCallAnUnpluggedCameraAbsentToo) {
  voice.trouble(Trouble::kUnplugged, "gone");
  voice.trouble(Trouble::kAbsent, "there is none");
  EXPECT_THAT(heard, ElementsAre("gone"));
}

TEST_F(VoiceTest, MakesARemarkOnce) {
  voice.remark("this");
  voice.remark("that");
  voice.remark("this");
  EXPECT_THAT(heard, ElementsAre("this", "that"));
}

TEST_F(VoiceTest, SaysNothingWhenMuted) {
  voice.mute();
  voice.trouble(Trouble::kBusy, "busy");
  EXPECT_THAT(heard, IsEmpty());
}

TEST(Voice, LivesWithAListenerThatThrowsAndWithNone) {
  Voice angry{[](const std::string&) { throw std::runtime_error("not now"); }};
  EXPECT_NO_THROW(angry.trouble(Trouble::kBusy, "busy"));
  Voice lonely{nullptr};
  EXPECT_NO_THROW(lonely.remark("hello"));
}

}  // namespace
}  // namespace darwinop::v4l2
