// The constants of gap/thresholds.hpp as tools/gap-sensitivity.sh compiles them: a run counts the comparisons that half
// or twice a constant would have decided otherwise, and DARWINOP_THRESHOLD and DARWINOP_FACTOR scale one of them.
#pragma once

#include <algorithm>
#include <atomic>
#include <cmath>
#include <concepts>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <type_traits>
#include <vector>

namespace darwinop::gap::thresholds {

template <class T>
concept Number = std::is_arithmetic_v<T>;

template <Number T>
T scaled(T value, double factor) {
  const double by = factor * static_cast<double>(value);
  return static_cast<T>(std::is_integral_v<T> ? std::ceil(by) : by);
}

/// The value of a constant in this run.
template <Number T>
T setting(const char* name, T value) {
  const char* const wanted = std::getenv("DARWINOP_THRESHOLD");
  if (wanted == nullptr || std::strcmp(wanted, name) != 0) return value;
  return scaled(value, std::atof(std::getenv("DARWINOP_FACTOR")));
}

/// Of one constant: comparisons, how many half and twice of it decide otherwise, and uses as a plain number.
struct Margin {
  const char* name = nullptr;
  std::atomic<long> compared = 0, other_at_half = 0, other_at_twice = 0, as_number = 0;

  ~Margin() {
    const char* const path = std::getenv("DARWINOP_MARGINS");
    std::FILE* const file = path == nullptr ? nullptr : std::fopen(path, "a");
    if (file == nullptr) return;
    std::fprintf(file, "%s\t%ld\t%ld\t%ld\t%ld\n", name, compared.load(), other_at_half.load(), other_at_twice.load(),
                 as_number.load());
    std::fclose(file);
  }
};

/// What is computed from constants: its value, and what it would be at half and at twice each of them.
class Tracked {
 public:
  template <Number T>
  Tracked(Margin& margin, T value)
      : value_{static_cast<double>(value)},
        variants_{{&margin, static_cast<double>(scaled(value, 0.5)), static_cast<double>(scaled(value, 2))}} {}
  explicit Tracked(double value) : value_{value} {}

  /// Elsewhere than in arithmetic and comparisons.
  template <Number T>
  operator T() const {  // NOLINT(google-explicit-constructor): the constants are plain numbers in the product
    for (const Variant& one : variants_) ++one.margin->as_number;
    return static_cast<T>(value_);
  }
  /// To be printed.
  double operator+() const { return value_; }

  template <class Function>
  friend Tracked combined(const Tracked& a, const Tracked& b, Function function) {
    Tracked out{function(a.value_, b.value_)};
    Tracked::forEachVariant(a, b, [&](Margin& margin, const Variant& one, const Variant& other) {
      out.variants_.push_back({&margin, function(one.half, other.half), function(one.twice, other.twice)});
    });
    return out;
  }
  template <class Function>
  friend bool compared(const Tracked& a, const Tracked& b, Function function) {
    const bool result = function(a.value_, b.value_);
    Tracked::forEachVariant(a, b, [&](Margin& margin, const Variant& one, const Variant& other) {
      ++margin.compared;
      if (function(one.half, other.half) != result) ++margin.other_at_half;
      if (function(one.twice, other.twice) != result) ++margin.other_at_twice;
    });
    return result;
  }

 private:
  struct Variant {
    Margin* margin;
    double half, twice;
  };

  [[nodiscard]] Variant at(Margin* margin) const {
    const auto there = std::ranges::find(variants_, margin, &Variant::margin);
    return there == variants_.end() ? Variant{margin, value_, value_} : *there;
  }
  template <class Use>
  static void forEachVariant(const Tracked& a, const Tracked& b, Use use) {
    for (const Variant& one : a.variants_) use(*one.margin, one, b.at(one.margin));
    for (const Variant& one : b.variants_)
      if (std::ranges::find(a.variants_, one.margin, &Variant::margin) == a.variants_.end())
        use(*one.margin, a.at(one.margin), one);
  }

  double value_;
  std::vector<Variant> variants_;
};

inline const Tracked& tracked(const Tracked& value) {
  return value;
}
template <Number T>
Tracked tracked(T value) {
  return Tracked{static_cast<double>(value)};
}

template <class A, class B>
concept OneIsTracked = (std::same_as<A, Tracked> && (std::same_as<B, Tracked> || Number<B>)) ||
                       (Number<A> && std::same_as<B, Tracked>);

#define DARWINOP_OPERATOR(SIGN, HOW)                                                 \
  template <class A, class B>                                                        \
  requires OneIsTracked<A, B>                                                        \
  auto operator SIGN(const A& a, const B& b) {                                       \
    return HOW(tracked(a), tracked(b), [](double x, double y) { return x SIGN y; }); \
  }
DARWINOP_OPERATOR(+, combined)
DARWINOP_OPERATOR(-, combined)
DARWINOP_OPERATOR(*, combined)
DARWINOP_OPERATOR(/, combined)
DARWINOP_OPERATOR(<, compared)
DARWINOP_OPERATOR(>, compared)
DARWINOP_OPERATOR(<=, compared)
DARWINOP_OPERATOR(>=, compared)
DARWINOP_OPERATOR(==, compared)
#undef DARWINOP_OPERATOR

}  // namespace darwinop::gap::thresholds

// The product writes std::max and std::min; the templates of the library take two of one type.
namespace std {

template <class A, class B>
requires darwinop::gap::thresholds::OneIsTracked<A, B>
auto max(const A& a, const B& b) {
  using darwinop::gap::thresholds::tracked;
  return combined(tracked(a), tracked(b), [](double x, double y) { return x < y ? y : x; });
}
template <class A, class B>
requires darwinop::gap::thresholds::OneIsTracked<A, B>
auto min(const A& a, const B& b) {
  using darwinop::gap::thresholds::tracked;
  return combined(tracked(a), tracked(b), [](double x, double y) { return y < x ? y : x; });
}

}  // namespace std
