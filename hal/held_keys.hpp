// Set of held keys: written by a device's thread, read by the controller's.
#pragma once

#include <algorithm>
#include <cstdint>
#include <mutex>
#include <vector>

#include "hal/keyboard.hpp"

namespace darwinop {

/// A key pressed and released between two calls of take() is returned once. The lock is held for a few memory moves;
/// the loop's thread never takes it.
class HeldKeys {
 public:
  /// `id` identifies the physical key: two keys may have the same code.
  void press(std::uint32_t id, Key code, Key modifiers) {
    const std::lock_guard lock{mutex_};
    const auto known = find(id);
    if (known == keys_.end())
      keys_.push_back({id, code, modifiers, modifiers, true});
    else
      *known = {id, code, modifiers, modifiers, true};
  }

  void release(std::uint32_t id) {
    const std::lock_guard lock{mutex_};
    const auto known = find(id);
    if (known != keys_.end()) up(*known);
    forgetTheTaken();
  }

  void releaseAll() {
    const std::lock_guard lock{mutex_};
    for (Held& key : keys_) up(key);
    forgetTheTaken();
  }

  /// Shift or another modifier changed while keys are held. A key not yet returned by take() is returned with the
  /// modifiers at the time of its press.
  void setModifiers(Key modifiers) {
    const std::lock_guard lock{mutex_};
    for (Held& key : keys_)
      if (key.down) key.next_modifiers = modifiers;
  }

  [[nodiscard]] std::vector<Key> down() const {
    const std::lock_guard lock{mutex_};
    std::vector<Key> all;
    for (const Held& key : keys_)
      if (key.down) addOnce(all, key.code | key.next_modifiers);
    return all;
  }

  /// See KeySource::take().
  std::vector<Key> take() {
    const std::lock_guard lock{mutex_};
    std::vector<Key> all;
    for (Held& key : keys_) {
      addOnce(all, key.code | (key.taken ? key.next_modifiers : key.modifiers));
      key.taken = true;
    }
    forgetTheTaken();
    return all;
  }

 private:
  struct Held {
    std::uint32_t id;
    Key code, modifiers, next_modifiers;
    bool down, taken = false;
  };

  static void addOnce(std::vector<Key>& all, Key key) {
    if (std::ranges::find(all, key) == all.end()) all.push_back(key);
  }
  static void up(Held& key) { key.down = false; }
  std::vector<Held>::iterator find(std::uint32_t id) { return std::ranges::find(keys_, id, &Held::id); }
  void forgetTheTaken() {
    std::erase_if(keys_, [](const Held& key) { return !key.down && key.taken; });
  }

  mutable std::mutex mutex_;
  std::vector<Held> keys_;  // in the order of pressing
};

}  // namespace darwinop
