// Keys that a controller has not read yet.
#pragma once

#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

#include "hal/keyboard.hpp"

namespace darwinop::webots_api {

class KeyQueue {
 public:
  /// Without a source no key is ever pressed.
  explicit KeyQueue(std::unique_ptr<KeySource> source) : source_{std::move(source)} {}

  void refresh() {
    if (!source_) return;
    keys_ = source_->take();
    next_ = 0;
  }
  /// Next key; -1: none until the next refresh().
  int next() { return next_ < keys_.size() ? keys_[next_++] : -1; }

 private:
  std::unique_ptr<KeySource> source_;
  std::vector<Key> keys_;
  std::size_t next_ = 0;
};

}  // namespace darwinop::webots_api
