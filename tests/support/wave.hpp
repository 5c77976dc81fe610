// Sounds of a test: tones written as WAV files, and what is measured in one that was recorded.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <iterator>
#include <numbers>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace darwinop {

struct Wave {
  int rate = 0, channels = 0;
  std::vector<std::int16_t> samples;  // of all channels

  /// One channel, full scale is 1.
  [[nodiscard]] std::vector<double> channel(int which) const {
    std::vector<double> values;
    for (std::size_t i = static_cast<std::size_t>(which); i < samples.size(); i += static_cast<std::size_t>(channels))
      values.push_back(samples[i] / 32768.0);
    return values;
  }
};

inline double rms(std::span<const double> values) {
  double sum = 0;
  for (const double value : values) sum += value * value;
  return values.empty() ? 0 : std::sqrt(sum / static_cast<double>(values.size()));
}

/// Amplitude of one frequency (Goertzel).
inline double amplitudeAt(double hertz, std::span<const double> values, int rate) {
  const double c = 2 * std::cos(2 * std::numbers::pi * hertz / rate);
  double last = 0, before = 0;
  for (const double value : values) before = std::exchange(last, value + c * last - before);
  const double power = last * last + before * before - c * last * before;
  return 2 * std::sqrt(std::max(0.0, power)) / static_cast<double>(values.size());
}

/// From the first to the last audible value.
inline std::vector<double> audiblePart(const std::vector<double>& values) {
  const auto loud = [](double value) { return std::abs(value) > 0.002; };
  const auto first = std::ranges::find_if(values, loud);
  const auto last = std::find_if(values.rbegin(), std::make_reverse_iterator(first), loud).base();
  return {first, last};
}

inline std::vector<std::int16_t> tone(double hertz, double seconds, double amplitude, int rate) {
  std::vector<std::int16_t> samples(static_cast<std::size_t>(seconds * rate));
  for (std::size_t i = 0; i < samples.size(); ++i)
    samples[i] = static_cast<std::int16_t>(32767 * amplitude *
                                           std::sin(2 * std::numbers::pi * hertz * static_cast<double>(i) / rate));
  return samples;
}

inline void writeWave(const std::string& file, const Wave& wave) {
  const auto number = [](auto value) { return std::string(reinterpret_cast<const char*>(&value), sizeof value); };
  const auto bytes = static_cast<std::uint32_t>(wave.samples.size() * 2);
  const auto channels = static_cast<std::uint16_t>(wave.channels);
  std::ofstream out{file, std::ios::binary};
  out << "RIFF" << number(36 + bytes) << "WAVEfmt " << number(std::uint32_t{16}) << number(std::uint16_t{1})
      << number(channels) << number(static_cast<std::uint32_t>(wave.rate))
      << number(static_cast<std::uint32_t>(wave.rate * channels * 2))
      << number(static_cast<std::uint16_t>(channels * 2)) << number(std::uint16_t{16}) << "data" << number(bytes)
      << std::string(reinterpret_cast<const char*>(wave.samples.data()), bytes);
}

/// As ALSA's plugin "file" writes it: 16 bits, a head of 44 bytes.
inline Wave readWave(const std::string& file) {
  std::ifstream in{file, std::ios::binary};
  const std::string bytes{std::istreambuf_iterator<char>{in}, {}};
  if (bytes.size() < 44 || !bytes.starts_with("RIFF")) throw std::runtime_error(file + " is not a WAV file");
  Wave wave;
  std::uint16_t channels = 0;
  std::memcpy(&channels, bytes.data() + 22, sizeof channels);
  std::uint32_t rate = 0;
  std::memcpy(&rate, bytes.data() + 24, sizeof rate);
  wave.channels = channels;
  wave.rate = static_cast<int>(rate);
  wave.samples.resize((bytes.size() - 44) / 2);
  std::memcpy(wave.samples.data(), bytes.data() + 44, wave.samples.size() * 2);
  return wave;
}

}  // namespace darwinop
