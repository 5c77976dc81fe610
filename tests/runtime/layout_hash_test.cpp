// The hash that tells two builds with different memory apart.
#include "runtime/layout_hash.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <set>

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
DARWINOP_LAYOUT(LayoutBase, speed, torque);
DARWINOP_LAYOUT(LayoutSwapped, torque, speed);
DARWINOP_LAYOUT(LayoutSigned, speed, torque);
DARWINOP_LAYOUT(LayoutFloat, speed, torque);
DARWINOP_LAYOUT(LayoutLonger, speed, torque, gain);
DARWINOP_LAYOUT(LayoutNested, a);
DARWINOP_LAYOUT(LayoutOtherNested, a);

namespace {

/// Without the name of the struct itself.
template <class T>
std::uint64_t fieldsOf() {
  LayoutHash hash;
  Layout<T>::addTo(hash);
  return hash.value();
}

TEST(LayoutHash, TellsOrderTypeNumberAndNestedFieldsApart) {
  const std::set<std::uint64_t> different{
      fieldsOf<LayoutBase>(),   fieldsOf<LayoutSwapped>(), fieldsOf<LayoutSigned>(),     fieldsOf<LayoutFloat>(),
      fieldsOf<LayoutLonger>(), fieldsOf<LayoutNested>(),  fieldsOf<LayoutOtherNested>()};
  EXPECT_EQ(different.size(), 7u);
}

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
