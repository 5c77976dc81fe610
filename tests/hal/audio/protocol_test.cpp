// Orders and news on the wire between controller and sound program; names of voices.
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
const std::vector<SoundNews> kNews{SoundStarted{1, 2.5}, SoundEnded{0xFFFFFFFF}, SoundTrouble{"no card"},
                                   SoundLost{""}};

TEST(SoundProtocol, WhatIsWrittenIsRead) {
  for (const SoundOrder& order : kOrders) EXPECT_EQ(decodeOrder(encode(order)), order);
  for (const SoundNews& news : kNews) EXPECT_EQ(decodeNews(encode(news)), news);
}

TEST(SoundProtocol, APieceOfAMessageOrMoreThanOneIsNone) {
  for (const SoundOrder& order : kOrders) {
    Message message = encode(order);
    for (std::size_t size = 0; size < message.size(); ++size)
      EXPECT_FALSE(decodeOrder(std::span{message}.first(size))) << size;
    message.push_back(0);
    EXPECT_FALSE(decodeOrder(message));
    EXPECT_FALSE(decodeNews(message));
  }
  EXPECT_FALSE(decodeNews(encode(kOrders[0])));
  EXPECT_FALSE(decodeOrder(encode(kNews[0])));
}

TEST(SoundProtocol, NumbersOutOfTheirRangesAreRefused) {
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

TEST(SoundProtocol, LongTextsAreCutAndStillFitIntoAMessage) {
  const Message message = encode(SoundOrder{Speak{.text = std::string(100'000, 'x'), .voice = std::string(999, 'v')}});
  EXPECT_LE(message.size(), kLongestMessage);
  const auto order = decodeOrder(message);
  ASSERT_TRUE(order);
  EXPECT_EQ(std::get<Speak>(*order).text.size(), kLongestText);
  EXPECT_FALSE(decodeOrder(encode(SoundOrder{StopSound{std::string("a\0b", 3)}}))) << "a text ends before a NUL";
}

TEST(VoiceNames, OldNamesAreThoseOfTodayAndOthersStayWhatTheyAre) {
  EXPECT_EQ(voiceOfToday("en"), "en");
  EXPECT_EQ(voiceOfToday("de-DE"), "de");
  EXPECT_EQ(voiceOfToday("en-UK"), "en");
  EXPECT_EQ(voiceOfToday("pt"), "pt-br");
  EXPECT_EQ(voiceOfToday("zh-yue+f3"), "yue+f3");
  EXPECT_EQ(voiceOfToday(""), "");
}

}  // namespace
}  // namespace darwinop::audio
