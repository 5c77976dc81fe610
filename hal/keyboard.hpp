// Interface of a keyboard: the keys that are held down.
#pragma once

#include <vector>

namespace darwinop {

/// Key code plus the bits of the held modifiers. ASCII where a character exists, letters as capitals regardless of
/// Shift; otherwise as below.
using Key = int;

/// Values of the Webots API. (*): the API does not name this key; the value follows wxWidgets' numbering, from which
/// the API's values were taken.
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
  /// Every key that is down or went down since the last call, once each, in the order of pressing. Does not block. Used
  /// by one thread.
  virtual std::vector<Key> take() = 0;
};

}  // namespace darwinop
