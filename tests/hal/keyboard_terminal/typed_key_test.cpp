// Taps and held keys of a terminal.
#include "hal/keyboard_terminal/typed_key.hpp"

#include <gmock/gmock.h>

namespace darwinop::terminal {
namespace {

using std::chrono::milliseconds;
using testing::ElementsAre;
using testing::IsEmpty;

struct Typed : testing::Test {
  std::vector<Key> at(int ms) {
    typed.expire(milliseconds{ms});
    return keys.take();
  }
  HeldKeys keys;
  TypedKey typed{keys};
};

TEST_F(Typed, OneTapIsOnePressForOneStep) {
  for (const int ms : {0, 300, 450, 1000}) {  // one after the other, as fast as a person can
    typed.type(' ', milliseconds{ms});
    EXPECT_THAT(at(ms), ElementsAre(' ')) << ms;
    EXPECT_THAT(at(ms + 1), IsEmpty()) << ms;
  }
}

TEST_F(Typed, IsHeldWhileItRepeatsAndEndsSoonAfter) {
  typed.type(kKeyUp | kKeyShift, milliseconds{0});
  EXPECT_THAT(at(0), ElementsAre(kKeyUp | kKeyShift));
  typed.type(kKeyUp | kKeyShift, milliseconds{660});  // plain X11, the longest delay of all
  EXPECT_THAT(at(660), ElementsAre(kKeyUp | kKeyShift));
  for (int ms = 760; ms < 2000; ms += 100) {
    typed.type(kKeyUp | kKeyShift, milliseconds{ms});
    for (const int later : {0, 50, 99}) EXPECT_THAT(at(ms + later), ElementsAre(kKeyUp | kKeyShift)) << ms + later;
  }
  EXPECT_THAT(at(2159), ElementsAre(kKeyUp | kKeyShift));  // 1960 was the last one
  EXPECT_THAT(at(2160), IsEmpty());
}

TEST_F(Typed, SurvivesALateRepetition) {
  for (const int ms : {0, 500, 533, 712}) {
    typed.type('A', milliseconds{ms});
    EXPECT_THAT(at(ms), ElementsAre('A')) << ms;
  }
  EXPECT_THAT(at(911), ElementsAre('A'));
  EXPECT_THAT(at(912), IsEmpty());
}

TEST_F(Typed, EndsThoughNobodyLooksUntilItsNextTap) {
  for (const int ms : {0, 500, 533, 2000}) typed.type('A', milliseconds{ms});
  EXPECT_THAT(at(2000), ElementsAre('A'));
  EXPECT_THAT(at(2001), IsEmpty()) << "a tap";
}

TEST_F(Typed, IsEndedByAnotherOne) {
  for (const int ms : {0, 500, 533}) typed.type(kKeyUp, milliseconds{ms});
  EXPECT_THAT(at(540), ElementsAre(kKeyUp));
  typed.type(kKeyDown, milliseconds{550});
  EXPECT_THAT(at(551), ElementsAre(kKeyDown));
  EXPECT_THAT(at(552), IsEmpty());
}

TEST_F(Typed, IsReturnedEvenIfAnotherKeyEndedItAtOnce) {
  typed.type('A', milliseconds{0});
  typed.type('B', milliseconds{1});
  EXPECT_THAT(at(2), ElementsAre('A', 'B'));
  EXPECT_THAT(at(3), IsEmpty());
}

}  // namespace
}  // namespace darwinop::terminal
