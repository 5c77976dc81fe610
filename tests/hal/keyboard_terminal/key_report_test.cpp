// Key reports with releases.
#include "hal/keyboard_terminal/key_report.hpp"

#include <gmock/gmock.h>

#include "hal/keyboard_terminal/decoder.hpp"

namespace darwinop::terminal {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using Kind = KeyEvent::Kind;

struct KeyReports : testing::Test {
  std::vector<KeyEvent> feed(std::string_view bytes) { return decoder.feed(bytes, Nanos{0}); }
  void start() { EXPECT_THAT(feed("\x1b[?15u"), ElementsAre(KeyEvent{Kind::kReports, 15})); }
  KeyDecoder decoder;
};

TEST_F(KeyReports, OfTextKeysHavePressRepeatAndRelease) {
  start();
  EXPECT_THAT(feed("\x1b[32u\x1b[32;1:2u\x1b[32;1:3u"),
              ElementsAre(KeyEvent{Kind::kPressed, ' ', ' '}, KeyEvent{Kind::kPressed, ' ', ' '},
                          KeyEvent{Kind::kReleased, ' ', ' '}));
}

TEST_F(KeyReports, IdentifyAKeyWhateverIsHeldWithIt) {
  start();
  const auto events = feed("\x1b[97:65;2u\x1b[97;1:3u\x1b[49:33;2:1;33u\x1b[49;1:3u\x1b[105;5u");
  EXPECT_THAT(events, ElementsAre(KeyEvent{Kind::kPressed, 'A' | kKeyShift, 'A'}, KeyEvent{Kind::kReleased, 'A', 'A'},
                                  KeyEvent{Kind::kPressed, '1' | kKeyShift, '1'}, KeyEvent{Kind::kReleased, '1', '1'},
                                  KeyEvent{Kind::kPressed, 'I' | kKeyControl, 'I'}));
}

TEST_F(KeyReports, OfOtherKeysKeepTheirFormAndHaveReleasesToo) {
  start();
  EXPECT_THAT(feed("\x1b[A\x1b[1;1:3A\x1b[5;2~\x1b[5;2:3~\x1b[27u\x1b[127u"),
              ElementsAre(KeyEvent{Kind::kPressed, kKeyUp, kKeyUp}, KeyEvent{Kind::kReleased, kKeyUp, kKeyUp},
                          KeyEvent{Kind::kPressed, kKeyPageUp | kKeyShift, kKeyPageUp},
                          KeyEvent{Kind::kReleased, kKeyPageUp | kKeyShift, kKeyPageUp},
                          KeyEvent{Kind::kPressed, kKeyEscape, kKeyEscape},
                          KeyEvent{Kind::kPressed, kKeyBackspace, kKeyBackspace}));
}

TEST_F(KeyReports, OfAnotherAlphabetAreThoseOfTheBaseLayout) {
  start();
  EXPECT_THAT(feed("\x1b[1092::97;1:1u\x1b[1092u"), ElementsAre(KeyEvent{Kind::kPressed, 'A', 'A'}));
}

TEST_F(KeyReports, OfTheNumericPadAreItsKeys) {
  start();
  const auto events = feed("\x1b[57399u\x1b[57408u\x1b[57413u\x1b[57419u\x1b[57427u");
  ASSERT_EQ(events.size(), 5u);
  EXPECT_EQ(events[0].key, '0');
  EXPECT_EQ(events[1].key, '9');
  EXPECT_EQ(events[2].key, '+');
  EXPECT_EQ(events[3].key, kKeyNumpadUp);
  EXPECT_EQ(events[4].key, kKeyNumpadBegin);
}

TEST_F(KeyReports, OfModifierKeysAndFocusHaveKindsOfTheirOwn) {
  start();
  EXPECT_THAT(
      feed("\x1b[57441;2u\x1b[57441;1:3u\x1b[O\x1b[I\x1b[57358u"),
      ElementsAre(KeyEvent{Kind::kModifiers, kKeyShift}, KeyEvent{Kind::kModifiers, 0}, KeyEvent{Kind::kFocusLost}));
}

TEST_F(KeyReports, HaveNoReleaseUntilTheTerminalSaysSo) {
  EXPECT_THAT(feed("\x1b[?0u"), ElementsAre(KeyEvent{Kind::kReports, 0}));
  EXPECT_THAT(feed("\x1b[A\x1b[97;5u"),
              ElementsAre(KeyEvent{Kind::kTyped, kKeyUp, kKeyUp}, KeyEvent{Kind::kTyped, 'A' | kKeyControl, 'A'}));
  EXPECT_THAT(feed("\x1b[1;1:3A"), IsEmpty());
}

TEST_F(KeyReports, ThatAreTooLongAreDiscardedAsAWhole) {
  start();
  for (const std::string& report :
       {std::string(1000, '9'), "97" + std::string(100, ';'), std::string{";;;:::"}, std::string{"-1;-1:-1"}})
    EXPECT_THAT(feed("\x1b[" + report + "u"), IsEmpty()) << report;
  EXPECT_THAT(feed("\x1b[32u"), ElementsAre(KeyEvent{Kind::kPressed, ' ', ' '}));
}

}  // namespace
}  // namespace darwinop::terminal
