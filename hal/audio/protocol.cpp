// Messages between a controller and its sound process; one packet of a local socket each.
#include "hal/audio/protocol.hpp"

#include <algorithm>
#include <cstring>
#include <string>
#include <type_traits>
#include <utility>

namespace darwinop::audio {

namespace {

enum Kind : std::uint8_t { kPlay = 1, kSpeak, kStop, kStarted = 101, kEnded, kError, kLost };

class Writer {
 public:
  explicit Writer(Kind kind) : message_{kind} {}
  template <class Number>
  Writer& number(Number value) {
    static_assert(std::is_arithmetic_v<Number>);
    std::uint8_t bytes[sizeof value];
    std::memcpy(bytes, &value, sizeof value);
    message_.insert(message_.end(), bytes, bytes + sizeof value);
    return *this;
  }
  Writer& flag(bool value) { return number(static_cast<std::uint8_t>(value)); }
  Writer& text(const std::string& value) {
    const std::size_t size = std::min(value.size(), kLongestText);
    number(static_cast<std::uint32_t>(size));
    message_.insert(message_.end(), value.begin(), value.begin() + static_cast<std::ptrdiff_t>(size));
    return *this;
  }
  [[nodiscard]] Message done() { return std::move(message_); }

 private:
  Message message_;
};

/// After the first error every value is 0 or empty.
class Reader {
 public:
  explicit Reader(std::span<const std::uint8_t> message) : left_{message} {}
  template <class Number>
  Number number() {
    Number value{};
    const auto bytes = take(sizeof value);
    if (!bytes.empty()) std::memcpy(&value, bytes.data(), sizeof value);
    return value;
  }
  double between(double low, double high) {
    const auto value = number<double>();
    good_ = good_ && value >= low && value <= high;  // false for NaN
    return good_ ? value : low;                      // out of range may not fit into int
  }
  bool flag() {
    const auto value = number<std::uint8_t>();
    good_ = good_ && value <= 1;
    return value == 1;
  }
  std::string text(std::size_t longest = kLongestText) {
    const auto size = number<std::uint32_t>();
    good_ = good_ && size <= longest;
    const auto bytes = take(good_ ? size : 0);
    good_ = good_ && std::ranges::find(bytes, 0) == bytes.end();
    return {bytes.begin(), bytes.end()};
  }
  [[nodiscard]] bool complete() const { return good_ && left_.empty(); }

 private:
  std::span<const std::uint8_t> take(std::size_t size) {
    good_ = good_ && size <= left_.size();
    if (!good_) return {};
    const auto taken = left_.first(size);
    left_ = left_.subspan(size);
    return taken;
  }

  std::span<const std::uint8_t> left_;
  bool good_ = true;
};

Message written(const PlaySound& play) {
  return Writer{kPlay}
      .number(play.id)
      .text(play.file)
      .number(play.volume)
      .number(play.pitch)
      .number(play.balance)
      .flag(play.loop)
      .flag(play.afresh)
      .done();
}
Message written(const Speak& speak) {
  return Writer{kSpeak}
      .number(speak.id)
      .text(speak.text)
      .flag(speak.text_is_file)
      .text(speak.voice.substr(0, kLongestVoice))
      .number(static_cast<double>(speak.words_per_minute))
      .number(speak.volume)
      .done();
}
Message written(const StopSound& stop) {
  return Writer{kStop}.text(stop.file).done();
}
Message written(const SoundStarted& started) {
  return Writer{kStarted}.number(started.id).number(started.seconds).done();
}
Message written(const SoundEnded& ended) {
  return Writer{kEnded}.number(ended.id).done();
}
Message written(const SoundError& error) {
  return Writer{kError}.text(error.sentence).done();
}
Message written(const SoundLost& lost) {
  return Writer{kLost}.text(lost.sentence).done();
}

std::optional<SoundOrder> readOrder(Reader& in) {
  switch (in.number<std::uint8_t>()) {
    case kPlay: {
      PlaySound play;
      play.id = in.number<SoundId>();
      play.file = in.text();
      play.volume = in.between(0, 1);
      play.pitch = in.between(0.5, 2);
      play.balance = in.between(-1, 1);
      play.loop = in.flag();
      play.afresh = in.flag();
      return play;
    }
    case kSpeak: {
      Speak speak;
      speak.id = in.number<SoundId>();
      speak.text = in.text();
      speak.text_is_file = in.flag();
      speak.voice = in.text(kLongestVoice);
      speak.words_per_minute = static_cast<int>(in.between(80, 450));
      speak.volume = in.between(0, 1);
      return speak;
    }
    case kStop:
      return StopSound{in.text()};
    default:
      return std::nullopt;
  }
}

std::optional<SoundEvent> readEvent(Reader& in) {
  switch (in.number<std::uint8_t>()) {
    case kStarted: {
      SoundStarted started;
      started.id = in.number<SoundId>();
      started.seconds = in.number<double>();
      return started;
    }
    case kEnded:
      return SoundEnded{in.number<SoundId>()};
    case kError:
      return SoundError{in.text()};
    case kLost:
      return SoundLost{in.text()};
    default:
      return std::nullopt;
  }
}

}  // namespace

Message encode(const SoundOrder& order) {
  return std::visit([](const auto& one) { return written(one); }, order);
}
Message encode(const SoundEvent& event) {
  return std::visit([](const auto& one) { return written(one); }, event);
}

std::optional<SoundOrder> decodeOrder(std::span<const std::uint8_t> message) {
  Reader in{message};
  auto order = readOrder(in);
  return in.complete() ? order : std::nullopt;
}

std::optional<SoundEvent> decodeEvent(std::span<const std::uint8_t> message) {
  Reader in{message};
  auto event = readEvent(in);
  return in.complete() ? event : std::nullopt;
}

}  // namespace darwinop::audio
