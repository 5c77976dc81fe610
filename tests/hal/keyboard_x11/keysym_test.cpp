// X11's keys as controllers get them.
#include "hal/keyboard_x11/keysym.hpp"

#include <X11/keysym.h>
#include <gtest/gtest.h>

#include <array>

namespace darwinop::x11 {
namespace {

using Syms = std::array<std::uint32_t, 4>;  // plain, Shift, and both of the second layout

TEST(Keysym, LettersAreCapitals) {
  EXPECT_EQ(keyOfKeysyms(Syms{XK_a, XK_A}, false), 'A');
  EXPECT_EQ(keyOfKeysyms(Syms{XK_z, XK_Z}, false), 'Z');
}

TEST(Keysym, DigitsAndMarksAreWhatTheyAreWithoutShift) {
  EXPECT_EQ(keyOfKeysyms(Syms{XK_1, XK_exclam}, false), '1');
  EXPECT_EQ(keyOfKeysyms(Syms{XK_comma, XK_less}, false), ',');
  EXPECT_EQ(keyOfKeysyms(Syms{XK_space}, false), ' ');
}

TEST(Keysym, ArrowsAndTheirNeighboursHaveTheNumbersOfTheApi) {
  EXPECT_EQ(keyOfKeysym(XK_Left), 314);
  EXPECT_EQ(keyOfKeysym(XK_Up), 315);
  EXPECT_EQ(keyOfKeysym(XK_Right), 316);
  EXPECT_EQ(keyOfKeysym(XK_Down), 317);
  EXPECT_EQ(keyOfKeysym(XK_End), 312);
  EXPECT_EQ(keyOfKeysym(XK_Home), 313);
  EXPECT_EQ(keyOfKeysym(XK_Page_Up), 366);
  EXPECT_EQ(keyOfKeysym(XK_Page_Down), 367);
}

TEST(Keysym, FunctionKeysAreInARow) {
  EXPECT_EQ(keyOfKeysym(XK_F1), 340);
  EXPECT_EQ(keyOfKeysym(XK_F12), 351);
}

TEST(Keysym, TheNumericPadHasArrowsOfItsOwnAndWithNumLockDigits) {
  const Syms seven{XK_KP_Home, XK_KP_7};
  EXPECT_EQ(keyOfKeysyms(seven, false), 375);
  EXPECT_EQ(keyOfKeysyms(seven, true), '7');
  EXPECT_EQ(keyOfKeysyms(Syms{XK_KP_Delete, XK_KP_Decimal}, true), '.');
  EXPECT_EQ(keyOfKeysyms(Syms{XK_KP_Add, XK_KP_Add}, false), '+');
  EXPECT_EQ(keyOfKeysyms(Syms{XK_KP_Divide}, true), '/');
}

TEST(Keysym, AKeyThatAsciiDoesNotHaveIsWhatItIsElsewhere) {
  EXPECT_EQ(keyOfKeysyms(Syms{XK_eacute, XK_2}, false), '2');                             // French
  EXPECT_EQ(keyOfKeysyms(Syms{XK_Cyrillic_ef, XK_Cyrillic_EF, XK_a, XK_A}, false), 'A');  // Russian
  EXPECT_EQ(keyOfKeysyms(Syms{XK_Caps_Lock}, false), std::nullopt);
  EXPECT_EQ(keyOfKeysyms({}, false), std::nullopt);
}

TEST(Keysym, ModifiersAreBits) {
  EXPECT_EQ(modifierOfKeysym(XK_Shift_R), 0x10000);
  EXPECT_EQ(modifierOfKeysym(XK_Control_L), 0x20000);
  EXPECT_EQ(modifierOfKeysym(XK_Alt_L), 0x40000);
  EXPECT_EQ(modifierOfKeysym(XK_a), 0);
  EXPECT_EQ(modifiersOfState(0b1101), 0x70000);
  EXPECT_EQ(modifiersOfState(0b10010), 0);  // Caps Lock, Num Lock
  EXPECT_TRUE(numLockOfState(0b10000));
}

TEST(Keysym, HasNamesForPeople) {
  EXPECT_EQ(keyName(kKeyControl | kKeyShift | 'A'), "Control+Shift+A");
  EXPECT_EQ(keyName(' '), "Space");
  EXPECT_EQ(keyName(kKeyNumpadUp), "Numpad Up");
  EXPECT_EQ(keyName(kKeyF12), "F12");
}

}  // namespace
}  // namespace darwinop::x11
