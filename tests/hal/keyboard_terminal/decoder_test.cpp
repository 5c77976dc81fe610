// Terminal key sequences.
#include "hal/keyboard_terminal/decoder.hpp"

#include <gmock/gmock.h>

namespace darwinop::terminal {
namespace {

using std::chrono::milliseconds;
using testing::ElementsAre;
using testing::IsEmpty;

using Kind = KeyEvent::Kind;

/// All of them without releases.
std::vector<Key> keysOf(const std::vector<KeyEvent>& events) {
  std::vector<Key> keys;
  for (const KeyEvent& event : events) {
    EXPECT_EQ(event.kind, Kind::kTyped) << event.key;
    keys.push_back(event.key);
  }
  return keys;
}
std::vector<Key> keysOf(std::string_view bytes) {
  return keysOf(KeyDecoder{}.feed(bytes, Nanos{0}));
}
std::optional<Key> keyAfter(KeyDecoder& decoder, Nanos now) {
  const auto event = decoder.timeOut(now);
  return event ? std::optional{event->key} : std::nullopt;
}

TEST(KeyDecoder, DecodesLettersAsCapitalsAndShiftFromTheirCase) {
  EXPECT_THAT(keysOf("a Z1!"), ElementsAre('A', ' ', 'Z' | kKeyShift, '1', '!'));
}

TEST(KeyDecoder, DecodesControlAndAlt) {
  EXPECT_THAT(keysOf("\x01\x1a"), ElementsAre('A' | kKeyControl, 'Z' | kKeyControl));
  EXPECT_THAT(keysOf("\x1bq"), ElementsAre('Q' | kKeyAlt));
  EXPECT_THAT(keysOf("\r\t\x7f"), ElementsAre(kKeyEnter, kKeyTab, kKeyBackspace));
}

TEST(KeyDecoder, DecodesArrowsInBothTerminalModes) {
  EXPECT_THAT(keysOf("\x1b[A\x1b[B\x1b[C\x1b[D"), ElementsAre(kKeyUp, kKeyDown, kKeyRight, kKeyLeft));
  EXPECT_THAT(keysOf("\x1bOA\x1bOD"), ElementsAre(kKeyUp, kKeyLeft));
  EXPECT_THAT(keysOf("\x1b[1;2A\x1b[1;5C\x1b[1;4D"),
              ElementsAre(kKeyUp | kKeyShift, kKeyRight | kKeyControl, kKeyLeft | kKeyShift | kKeyAlt));
}

TEST(KeyDecoder, DecodesTheOtherKeysOfThreeTerminalTypes) {
  EXPECT_THAT(keysOf("\x1b[H\x1b[1~\x1b[7~\x1bOH"), ElementsAre(kKeyHome, kKeyHome, kKeyHome, kKeyHome));
  EXPECT_THAT(keysOf("\x1b[F\x1b[4~\x1b[5~\x1b[6~\x1b[2~\x1b[3~"),
              ElementsAre(kKeyEnd, kKeyEnd, kKeyPageUp, kKeyPageDown, kKeyInsert, kKeyDelete));
  EXPECT_THAT(keysOf("\x1bOP\x1b[11~\x1b[[A\x1b[15~\x1b[24~"),
              ElementsAre(kKeyF1, kKeyF1, kKeyF1, kKeyF1 + 4, kKeyF12));
  EXPECT_THAT(keysOf("\x1b[15;2~"), ElementsAre((kKeyF1 + 4) | kKeyShift));
}

TEST(KeyDecoder, DiscardsUnknownSequences) {
  EXPECT_THAT(keysOf("\x1b[?1;2cx"), ElementsAre('X'));  // a terminal identification report
  EXPECT_THAT(keysOf("\x1b[99999999999~x"), ElementsAre('X'));
  EXPECT_THAT(keysOf("\xc3\xa9x"), ElementsAre('X'));  // e with an accent
  EXPECT_THAT(keysOf("\x1b[200~"), IsEmpty());
}

TEST(KeyDecoder, WaitsForTheRestOfASequence) {
  KeyDecoder decoder;
  EXPECT_THAT(decoder.feed("\x1b", milliseconds{0}), IsEmpty());
  EXPECT_THAT(decoder.feed("[", milliseconds{30}), IsEmpty());
  EXPECT_THAT(keysOf(decoder.feed("A", milliseconds{60})), ElementsAre(kKeyUp));
}

TEST(KeyDecoder, DecodesALoneEscapeAsTheKey) {
  KeyDecoder decoder;
  EXPECT_THAT(decoder.feed("\x1b", milliseconds{0}), IsEmpty());
  EXPECT_EQ(keyAfter(decoder, milliseconds{79}), std::nullopt);
  EXPECT_EQ(keyAfter(decoder, milliseconds{80}), kKeyEscape);
  EXPECT_EQ(keyAfter(decoder, milliseconds{999}), std::nullopt);
  EXPECT_THAT(decoder.feed("\x1b", milliseconds{1000}), IsEmpty());
  EXPECT_THAT(keysOf(decoder.feed("a", milliseconds{2000})), ElementsAre(kKeyEscape, 'A'));
}

}  // namespace
}  // namespace darwinop::terminal
