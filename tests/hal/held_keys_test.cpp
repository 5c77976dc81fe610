// Which keys a controller is told of.
#include "hal/held_keys.hpp"

#include <gmock/gmock.h>

namespace darwinop {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(HeldKeys, AreToldOnceAStepInTheOrderOfPressing) {
  HeldKeys keys;
  keys.press(2, kKeyUp, 0);
  keys.press(1, 'A', 0);
  EXPECT_THAT(keys.take(), ElementsAre(kKeyUp, 'A'));
  EXPECT_THAT(keys.take(), ElementsAre(kKeyUp, 'A'));
  keys.release(2);
  EXPECT_THAT(keys.take(), ElementsAre('A'));
  keys.release(1);
  EXPECT_THAT(keys.take(), IsEmpty());
}

TEST(HeldKeys, AreToldThoughTheyWentUpBeforeAnyoneAsked) {
  HeldKeys keys;
  for (int i = 0; i < 3; ++i) {
    keys.press(1, ' ', 0);
    keys.release(1);
  }
  EXPECT_THAT(keys.take(), ElementsAre(' '));
  EXPECT_THAT(keys.take(), IsEmpty());
}

TEST(HeldKeys, TakeTheModifiersThatComeAndGo) {
  HeldKeys keys;
  keys.press(1, 'A', kKeyShift);
  EXPECT_THAT(keys.take(), ElementsAre('A' | kKeyShift));
  keys.setModifiers(kKeyControl);
  EXPECT_THAT(keys.take(), ElementsAre('A' | kKeyControl));
  keys.setModifiers(0);
  EXPECT_THAT(keys.down(), ElementsAre('A'));
}

TEST(HeldKeys, HaveTheModifiersTheyWentDownWithThoughThoseWereQuickerUp) {
  HeldKeys keys;
  keys.press(1, 'X', kKeyControl);
  keys.setModifiers(0);
  keys.release(1);
  EXPECT_THAT(keys.take(), ElementsAre('X' | kKeyControl));
}

TEST(HeldKeys, OfOneCodeAreOneKey) {
  HeldKeys keys;
  keys.press(1, kKeyEnter, 0);
  keys.press(2, kKeyEnter, 0);
  EXPECT_THAT(keys.take(), ElementsAre(kKeyEnter));
  keys.release(1);
  EXPECT_THAT(keys.take(), ElementsAre(kKeyEnter));
}

TEST(HeldKeys, AreAllLetGoTogether) {
  HeldKeys keys;
  keys.press(1, kKeyUp, 0);
  keys.press(2, kKeyLeft, 0);
  EXPECT_THAT(keys.take(), ElementsAre(kKeyUp, kKeyLeft));
  keys.releaseAll();
  EXPECT_THAT(keys.take(), IsEmpty());
}

}  // namespace
}  // namespace darwinop
