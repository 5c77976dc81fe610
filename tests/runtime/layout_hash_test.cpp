// Hash that distinguishes builds with different memory layouts.
#include "runtime/layout_hash.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <set>
#include <string_view>

#include "runtime/exchange.hpp"

namespace darwinop::runtime {

struct LayoutBase {
  std::uint32_t speed, torque;
};
struct LayoutSwapped {
  std::uint32_t torque, speed;
};
struct LayoutSigned {
  std::int32_t speed;
  std::uint32_t torque;
};
struct LayoutFloat {
  float speed;
  std::uint32_t torque;
};
struct LayoutLonger {
  std::uint32_t speed, torque, gain;
};
struct LayoutNested {
  LayoutBase a;
};
struct LayoutOtherNested {
  LayoutSwapped a;
};
struct LayoutOfMany {  // as many fields as the macro is for
  bool a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r, s, t, u, v, w;
  std::uint8_t x;
};
DARWINOP_LAYOUT(LayoutBase, speed, torque);
DARWINOP_LAYOUT(LayoutSwapped, torque, speed);
DARWINOP_LAYOUT(LayoutSigned, speed, torque);
DARWINOP_LAYOUT(LayoutFloat, speed, torque);
DARWINOP_LAYOUT(LayoutLonger, speed, torque, gain);
DARWINOP_LAYOUT(LayoutNested, a);
DARWINOP_LAYOUT(LayoutOtherNested, a);
DARWINOP_LAYOUT(LayoutOfMany, a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r, s, t, u, v, w, x);

namespace {

/// Without the name of the struct itself.
template <class T>
constexpr std::uint64_t fieldsOf() {
  LayoutHash hash;
  Layout<T>::addFieldsTo(hash);
  return hash.value();
}

TEST(LayoutHash, DistinguishesOrderTypeNumberAndNestedFields) {
  const std::set<std::uint64_t> different{
      fieldsOf<LayoutBase>(),   fieldsOf<LayoutSwapped>(), fieldsOf<LayoutSigned>(),     fieldsOf<LayoutFloat>(),
      fieldsOf<LayoutLonger>(), fieldsOf<LayoutNested>(),  fieldsOf<LayoutOtherNested>()};
  EXPECT_EQ(different.size(), 7u);
}

constexpr std::uint64_t hashOfMany() {
  LayoutHash hash;
  std::size_t offset = 0;
  for (const char name : std::string_view{"abcdefghijklmnopqrstuvw"})
    hash.add(std::string_view{&name, 1}).add(offset++).add("unsigned").add(1);
  return hash.add("x").add(23).add("unsigned").add(1).value();
}
static_assert(fieldsOf<LayoutOfMany>() == hashOfMany());

TEST(LayoutHash, OfTheExchangeIsThatOfTheBlock) {
  const auto exchange = Exchange::inMemory();
  EXPECT_EQ(exchange.block().layout, exchangeLayout());
  EXPECT_NE(exchangeLayout(), 0u);
}

TEST(LayoutHash, IsFnv1a) {
  // Of the bytes "a" and 0, computed by hand from the constants of the algorithm.
  EXPECT_EQ(LayoutHash{}.add("a").value(), (((0xcbf29ce484222325U ^ 'a') * 0x100000001b3U)) * 0x100000001b3U);
}

}  // namespace
}  // namespace darwinop::runtime
