// Hash of a type's memory layout: names, offsets, sizes and types of its fields.
#pragma once

#include <array>
#include <bitset>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <type_traits>

namespace darwinop::runtime {

/// 64-bit FNV-1a.
class LayoutHash {
 public:
  constexpr LayoutHash& add(std::string_view text) {
    for (const char letter : text) byte(static_cast<unsigned char>(letter));
    return byte(0);
  }
  constexpr LayoutHash& add(std::uint64_t number) {
    for (int i = 0; i < 8; ++i) byte(static_cast<unsigned char>(number >> (8 * i)));
    return *this;
  }
  [[nodiscard]] constexpr std::uint64_t value() const { return hash_; }

 private:
  constexpr LayoutHash& byte(unsigned char value) {
    hash_ = (hash_ ^ value) * 0x100000001b3U;
    return *this;
  }
  std::uint64_t hash_ = 0xcbf29ce484222325U;
};

/// For numbers, bool and enumerations. DARWINOP_LAYOUT specialises it for structs.
template <class T>
struct Layout {
  static_assert(std::is_arithmetic_v<T> || std::is_enum_v<T>, "name the fields of this type with DARWINOP_LAYOUT");
  static constexpr void addTo(LayoutHash& hash) {
    hash.add(std::is_floating_point_v<T> ? "float" : std::is_signed_v<T> ? "signed" : "unsigned").add(sizeof(T));
  }
};

template <class T, std::size_t kCount>
struct Layout<std::array<T, kCount>> {
  static constexpr void addTo(LayoutHash& hash) {
    hash.add("array").add(kCount);
    Layout<T>::addTo(hash);
  }
};

template <class T, std::size_t kCount>
struct Layout<T[kCount]> {
  static constexpr void addTo(LayoutHash& hash) { Layout<std::array<T, kCount>>::addTo(hash); }
};

template <std::size_t kCount>
struct Layout<std::bitset<kCount>> {
  static constexpr void addTo(LayoutHash& hash) { hash.add("bits").add(kCount).add(sizeof(std::bitset<kCount>)); }
};

/// For a class with private members: its name and size.
template <class T>
constexpr void addOpaque(LayoutHash& hash, std::string_view name) {
  hash.add(name).add(sizeof(T));
}

}  // namespace darwinop::runtime

// Applies a macro to each of up to 24 names.
#define DARWINOP_PARENTHESES ()
#define DARWINOP_EXPAND(...) DARWINOP_EXPAND3(DARWINOP_EXPAND3(DARWINOP_EXPAND3(__VA_ARGS__)))
#define DARWINOP_EXPAND3(...) DARWINOP_EXPAND2(DARWINOP_EXPAND2(DARWINOP_EXPAND2(__VA_ARGS__)))
#define DARWINOP_EXPAND2(...) DARWINOP_EXPAND1(DARWINOP_EXPAND1(DARWINOP_EXPAND1(__VA_ARGS__)))
#define DARWINOP_EXPAND1(...) __VA_ARGS__
#define DARWINOP_FIELDS(type, ...) __VA_OPT__(DARWINOP_EXPAND(DARWINOP_FIELDS_STEP(type, __VA_ARGS__)))
#define DARWINOP_FIELDS_STEP(type, name, ...)                   \
  hash.add(#name).add(offsetof(type, name));                    \
  darwinop::runtime::Layout<decltype(type::name)>::addTo(hash); \
  __VA_OPT__(DARWINOP_FIELDS_AGAIN DARWINOP_PARENTHESES(type, __VA_ARGS__))
#define DARWINOP_FIELDS_AGAIN() DARWINOP_FIELDS_STEP

/// Lists all fields of a struct, in order; use in namespace darwinop::runtime. The structured binding does not compile
/// if one is missing.
#define DARWINOP_LAYOUT(type, ...)                                                                                   \
  template <>                                                                                                        \
  struct Layout<type> {                                                                                              \
    [[maybe_unused]] static void namesAll(const type& value) { [[maybe_unused]] const auto& [__VA_ARGS__] = value; } \
    static constexpr void addFieldsTo(LayoutHash& hash) { DARWINOP_FIELDS(type, __VA_ARGS__) }                       \
    static constexpr void addTo(LayoutHash& hash) {                                                                  \
      hash.add(#type).add(sizeof(type));                                                                             \
      addFieldsTo(hash);                                                                                             \
    }                                                                                                                \
  }
