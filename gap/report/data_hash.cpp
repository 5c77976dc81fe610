#include "gap/report/data_hash.hpp"

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace darwinop::gap {
namespace {

constexpr std::size_t kBlock = 64;  // bytes

/// The first 32 bits behind the point of a root of the first primes (FIPS 180-4, 4.2.2 and 5.3.3).
template <std::size_t N>
std::array<std::uint32_t, N> rootsOfPrimes(double (*root)(double)) {
  std::array<std::uint32_t, N> bits{};
  std::size_t found = 0;
  for (int candidate = 2; found < N; ++candidate) {
    bool prime = true;
    for (int divisor = 2; divisor * divisor <= candidate; ++divisor) prime = prime && candidate % divisor != 0;
    if (!prime) continue;
    const double value = root(candidate);
    bits[found++] = static_cast<std::uint32_t>((value - std::floor(value)) * 4294967296.0);
  }
  return bits;
}

void addBlock(std::array<std::uint32_t, 8>& state, const unsigned char* block) {
  static const auto kRounds = rootsOfPrimes<64>([](double x) { return std::cbrt(x); });
  std::array<std::uint32_t, 64> w{};
  for (std::size_t i = 0; i < 16; ++i)
    for (std::size_t byte = 0; byte < 4; ++byte) w[i] = w[i] << 8 | block[4 * i + byte];
  for (std::size_t i = 16; i < 64; ++i)
    w[i] = w[i - 16] + w[i - 7] + (std::rotr(w[i - 15], 7) ^ std::rotr(w[i - 15], 18) ^ w[i - 15] >> 3) +
           (std::rotr(w[i - 2], 17) ^ std::rotr(w[i - 2], 19) ^ w[i - 2] >> 10);
  auto [a, b, c, d, e, f, g, h] = state;
  for (std::size_t i = 0; i < 64; ++i) {
    const std::uint32_t first =
        h + (std::rotr(e, 6) ^ std::rotr(e, 11) ^ std::rotr(e, 25)) + ((e & f) ^ (~e & g)) + kRounds[i] + w[i];
    const std::uint32_t second =
        (std::rotr(a, 2) ^ std::rotr(a, 13) ^ std::rotr(a, 22)) + ((a & b) ^ (a & c) ^ (b & c));
    h = g, g = f, f = e, e = d + first, d = c, c = b, b = a, a = first + second;
  }
  const std::array<std::uint32_t, 8> sums{a, b, c, d, e, f, g, h};
  for (std::size_t i = 0; i < sums.size(); ++i) state[i] += sums[i];
}

std::vector<std::string> filesOf(const Case& given) {
  std::vector<std::string> files{"case.json"};
  for (const Trajectory& log : given.logs) files.push_back(log.file);
  return files;
}

}  // namespace

std::string sha256(std::string_view data) {
  auto state = rootsOfPrimes<8>([](double x) { return std::sqrt(x); });
  std::string padded{data};
  padded += '\x80';
  while (padded.size() % kBlock != kBlock - 8) padded += '\0';
  const std::uint64_t bits = std::uint64_t{data.size()} * 8;
  for (int shift = 56; shift >= 0; shift -= 8) padded += static_cast<char>(bits >> shift & 0xff);
  for (std::size_t at = 0; at < padded.size(); at += kBlock)
    addBlock(state, reinterpret_cast<const unsigned char*>(padded.data()) + at);
  std::string text;
  for (const std::uint32_t word : state)
    for (int shift = 28; shift >= 0; shift -= 4) text += "0123456789abcdef"[word >> shift & 0xf];
  return text;
}

std::string dataHash(const Case& given) {
  std::string all;
  for (const std::string& name : filesOf(given)) {
    std::ifstream file{std::filesystem::path{given.folder} / name, std::ios::binary};
    if (given.folder.empty() || !file) return "";
    all.append(std::istreambuf_iterator<char>{file}, {});
  }
  return sha256(all);
}

std::string hashCommand(const Case& given) {
  std::string command = "cat";
  for (const std::string& name : filesOf(given)) command += " " + shellWord(name);
  return command + " | sha256sum";
}

std::string shellWord(const std::string& text) {
  constexpr std::string_view kPlain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-./=:,@%+";
  if (!text.empty() && text.find_first_not_of(kPlain) == std::string::npos) return text;
  std::string quoted = "'";
  for (const char c : text) quoted += c == '\'' ? std::string{"'\\''"} : std::string{c};
  return quoted + "'";
}

}  // namespace darwinop::gap
