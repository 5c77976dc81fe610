// Messages between controller and sound process; voice names.
#include "hal/audio/protocol.hpp"

#include <gmock/gmock.h>

#include <limits>

#include "hal/audio/voice_names.hpp"

namespace darwinop::audio {
namespace {

const std::vector<SoundOrder> kOrders{
    PlaySound{.id = 7, .file = "/a b.mp3", .volume = 0.25, .pitch = 2, .balance = -1, .loop = true, .afresh = true},
    Speak{.id = 8, .text = "Grüße", .text_is_file = true, .voice = "de+f3", .words_per_minute = 450, .volume = 0},
    StopSound{""}, StopSound{"/x.wav"}};
const std::vector<SoundEvent> kEvents{SoundStarted{1, 2.5}, SoundEnded{0xFFFFFFFF}, SoundError{"no card"},
                                      SoundLost{""}};

TEST(SoundProtocol, MessagesSurviveTheRoundTrip) {
  for (const SoundOrder& order : kOrders) EXPECT_EQ(decodeOrder(encode(order)), order);
  for (const SoundEvent& event : kEvents) EXPECT_EQ(decodeEvent(encode(event)), event);
}

TEST(SoundProtocol, APartialOrOversizedMessageIsRejected) {
  for (const SoundOrder& order : kOrders) {
    Message message = encode(order);
    for (std::size_t size = 0; size < message.size(); ++size)
      EXPECT_FALSE(decodeOrder(std::span{message}.first(size))) << size;
    message.push_back(0);
    EXPECT_FALSE(decodeOrder(message));
    EXPECT_FALSE(decodeEvent(message));
  }
  EXPECT_FALSE(decodeEvent(encode(kOrders[0])));
  EXPECT_FALSE(decodeOrder(encode(kEvents[0])));
}

TEST(SoundProtocol, NumbersOutOfRangeAreRejected) {
  for (const double wrong :
       {-0.1, 1.1, 2.1, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    EXPECT_FALSE(decodeOrder(encode(SoundOrder{PlaySound{.volume = wrong}}))) << wrong;
    EXPECT_FALSE(decodeOrder(encode(SoundOrder{Speak{.volume = wrong}}))) << wrong;
  }
  for (const double wrong : {0.4, 2.1, std::numeric_limits<double>::quiet_NaN()})
    EXPECT_FALSE(decodeOrder(encode(SoundOrder{PlaySound{.pitch = wrong}}))) << wrong;
  EXPECT_FALSE(decodeOrder(encode(SoundOrder{PlaySound{.balance = -1.1}})));
  for (const int wrong : {-1, 79, 451}) EXPECT_FALSE(decodeOrder(encode(SoundOrder{Speak{.words_per_minute = wrong}})));
}

TEST(SoundProtocol, LongTextsAreTruncatedToFitAMessage) {
  const Message message = encode(SoundOrder{Speak{.text = std::string(100'000, 'x'), .voice = std::string(999, 'v')}});
  EXPECT_LE(message.size(), kLongestMessage);
  const auto order = decodeOrder(message);
  ASSERT_TRUE(order);
  EXPECT_EQ(std::get<Speak>(*order).text.size(), kLongestText);
  EXPECT_FALSE(decodeOrder(encode(SoundOrder{StopSound{std::string("a\0b", 3)}}))) << "a text ends before a NUL";
}

TEST(VoiceNames, OldNamesAreMappedAndOthersUnchanged) {
  EXPECT_EQ(voiceOfToday("en"), "en");
  EXPECT_EQ(voiceOfToday("de-DE"), "de");
  EXPECT_EQ(voiceOfToday("en-UK"), "en");
  EXPECT_EQ(voiceOfToday("pt"), "pt-br");
  EXPECT_EQ(voiceOfToday("zh-yue+f3"), "yue+f3");
  EXPECT_EQ(voiceOfToday(""), "");
}

}  // namespace
}  // namespace darwinop::audio
