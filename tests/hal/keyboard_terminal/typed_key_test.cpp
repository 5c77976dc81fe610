// How long a key of a terminal counts as held.
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

TEST_F(Typed, IsHeldUntilItCanHaveBeenRepeated) {
  typed.type(kKeyUp, milliseconds{0});
  EXPECT_THAT(at(0), ElementsAre(kKeyUp));
  EXPECT_THAT(at(699), ElementsAre(kKeyUp));
  EXPECT_THAT(at(700), IsEmpty());
}

TEST_F(Typed, HasNoGapWhileItRepeatsAndEndsSoonAfter) {
  typed.type(kKeyUp | kKeyShift, milliseconds{0});
  for (int ms = 660; ms < 2000; ms += 100) {
    EXPECT_THAT(at(ms), ElementsAre(kKeyUp | kKeyShift)) << ms;
    typed.type(kKeyUp | kKeyShift, milliseconds{ms});
  }
  EXPECT_THAT(at(2159), ElementsAre(kKeyUp | kKeyShift));  // 1960 was the last one
  EXPECT_THAT(at(2160), IsEmpty());
}

TEST_F(Typed, IsEndedByAnotherOne) {
  typed.type(kKeyUp, milliseconds{0});
  EXPECT_THAT(at(10), ElementsAre(kKeyUp));
  typed.type(kKeyDown, milliseconds{100});
  EXPECT_THAT(at(100), ElementsAre(kKeyDown));
  EXPECT_THAT(at(799), ElementsAre(kKeyDown));
  EXPECT_THAT(at(800), IsEmpty());
}

TEST_F(Typed, ThatAnotherOneEndedAtOnceIsToldAllTheSame) {
  typed.type('A', milliseconds{0});
  typed.type('B', milliseconds{1});
  EXPECT_THAT(at(2), ElementsAre('A', 'B'));
  EXPECT_THAT(at(3), ElementsAre('B'));
}

}  // namespace
}  // namespace darwinop::terminal
