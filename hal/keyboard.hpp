// Keys that a person holds down, as controllers get them: whatever they are read from.
#pragma once

#include <vector>

namespace darwinop {

/// The key's code, with the bits of the modifiers that are held with it. ASCII for what has a character, letters as
/// capitals, whatever Shift says; the rest as below.
using Key = int;

/// The numbers of the Webots API. Marked (*): the API has no name for them, they are where they lie in the numbering
/// that its other ones were taken from, that of wxWidgets.
enum KeyCode : Key {
  kKeyBackspace = 8,
  kKeyTab = 9,
  kKeyEnter = 13,
  kKeyEscape = 27,
  kKeyEnd = 312,
  kKeyHome = 313,
  kKeyLeft = 314,
  kKeyUp = 315,
  kKeyRight = 316,
  kKeyDown = 317,
  kKeyInsert = 322,  // (*)
  kKeyF1 = 340,      // (*) F1 to F12 in a row
  kKeyF12 = 351,     // (*)
  kKeyPageUp = 366,
  kKeyPageDown = 367,
  kKeyNumpadHome = 375,
  kKeyNumpadLeft = 376,
  kKeyNumpadUp = 377,
  kKeyNumpadRight = 378,
  kKeyNumpadDown = 379,
  kKeyNumpadPageUp = 380,    // (*)
  kKeyNumpadPageDown = 381,  // (*)
  kKeyNumpadEnd = 382,
  kKeyNumpadBegin = 383,   // (*) the 5 in the middle
  kKeyNumpadInsert = 384,  // (*)
  kKeyNumpadDelete = 385,  // (*)
  kKeyDelete = 127,
  kKeyCodeMask = 0x0000FFFF,
  kKeyShift = 0x00010000,
  kKeyControl = 0x00020000,
  kKeyAlt = 0x00040000,
};

class KeySource {
 public:
  virtual ~KeySource() = default;
  /// Every key that is down now, or went down since the last call, once each, in the order of pressing. Does not wait
  /// for the device. Used by one thread.
  virtual std::vector<Key> take() = 0;
};

}  // namespace darwinop
