// Keys of a terminal: result independent of chunking; documented codes only; after a pause the next letter is a key.
#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <string_view>
#include <vector>

#include "hal/held_keys.hpp"
#include "hal/keyboard_terminal/decoder.hpp"
#include "hal/keyboard_terminal/typed_key.hpp"

namespace {

using namespace darwinop;
using terminal::KeyDecoder;
using terminal::KeyEvent;
using terminal::Nanos;
using terminal::TypedKey;

void require(bool holds) {
  if (!holds) std::abort();
}

bool isDocumented(Key key) {
  const Key code = key & kKeyCodeMask;
  if ((key & ~(kKeyCodeMask | kKeyShift | kKeyControl | kKeyAlt)) != 0) return false;
  if (code == kKeyBackspace || code == kKeyTab || code == kKeyEnter || code == kKeyEscape || code == kKeyDelete)
    return true;
  if (code >= 'a' && code <= 'z') return false;  // letters are capitals
  return (code >= ' ' && code <= '~') || (code >= '[' - '@' + 'A' - 1 && code <= '_') ||
         (code >= kKeyEnd && code <= kKeyDown) || code == kKeyInsert || (code >= kKeyF1 && code <= kKeyF12) ||
         code == kKeyPageUp || code == kKeyPageDown || code == kKeyNumpadBegin;
}

bool isDocumented(const KeyEvent& event) {
  switch (event.kind) {
    case KeyEvent::Kind::kTyped:
    case KeyEvent::Kind::kPressed:
    case KeyEvent::Kind::kReleased:
      return isDocumented(event.key);
    case KeyEvent::Kind::kModifiers:
      return (event.key & ~(kKeyShift | kKeyControl | kKeyAlt)) == 0;
    case KeyEvent::Kind::kFocusLost:
    case KeyEvent::Kind::kReports:
      return true;
  }
  return false;
}

/// All bytes at one time: pieces of 1 + chunks[i] bytes, or the whole when there are no chunks.
std::vector<KeyEvent> eventsOf(std::string_view bytes, std::string_view chunks) {
  KeyDecoder decoder;
  std::vector<KeyEvent> events;
  for (std::size_t i = 0; !bytes.empty(); ++i) {
    const std::size_t size = chunks.empty() ? bytes.size() : 1U + static_cast<unsigned char>(chunks[i % chunks.size()]);
    for (const KeyEvent& event : decoder.feed(bytes.substr(0, size), Nanos{0})) events.push_back(event);
    bytes.remove_prefix(std::min(bytes.size(), size));
  }
  return events;
}

/// One byte after another with the pauses of `pauses`, in steps of 5 ms, as a slow network delivers them.
void typeSlowly(std::string_view bytes, std::string_view pauses) {
  KeyDecoder decoder;
  HeldKeys held;
  TypedKey typed{held};
  Nanos now{0};
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    if (!pauses.empty()) now += std::chrono::milliseconds{5} * static_cast<unsigned char>(pauses[i % pauses.size()]);
    const std::vector<KeyEvent> events = decoder.feed(bytes.substr(i, 1), now);
    require(events.size() <= 2);  // Escape that was alone, and this one
    for (const KeyEvent& event : events)
      if (event.kind == KeyEvent::Kind::kTyped) typed.type(event.key, now);
    typed.expire(now);
    require(held.down().size() <= 1);
    static_cast<void>(held.take());
  }
  now += KeyDecoder::kEscapeAlone;
  static_cast<void>(decoder.timeOut(now));
  require(!decoder.timeOut(now));
  const std::vector<KeyEvent> letter = decoder.feed("x", now);
  require(letter.size() == 1 && letter.front().key == 'X');
  typed.expire(now + TypedKey::kRepeated);
  require(held.down().empty());
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const std::string_view input{reinterpret_cast<const char*>(data), size};
  const std::size_t chunk_count = std::min<std::size_t>(data[0] % 16, size - 1);
  const std::string_view chunks = input.substr(1, chunk_count), bytes = input.substr(1 + chunk_count);

  const std::vector<KeyEvent> events = eventsOf(bytes, {});
  require(events.size() <= bytes.size());
  require(std::ranges::all_of(events, [](const KeyEvent& event) { return isDocumented(event); }));
  require(eventsOf(bytes, chunks) == events);
  typeSlowly(bytes, chunks);
  return 0;
}
