// Raw counts and colour words.
#include "core/counts.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace darwinop {
namespace {

TEST(Counts, EveryCountOfTheBoardComesBackExactly) {
  for (const Register* law : {&kGyroRegister, &kAccelRegister})
    for (int count = 0; count <= 1023; ++count)
      ASSERT_EQ(countFrom((count - law->zero) * law->scale, *law), count) << law->name;
}

TEST(Counts, UprightIs640) {
  EXPECT_EQ(countFrom(9.80665, kAccelRegister), 640);
}

TEST(Counts, UnknownIsNotACount) {
  EXPECT_TRUE(std::isnan(countFrom(Rad{}.value, kGyroRegister)));
}

TEST(Colours, RedIsInTheLowBitsAndBlueInTheHighOnes) {
  EXPECT_EQ(rgb15From24(0xFF0000), 0x001F);
  EXPECT_EQ(rgb15From24(0x00FF00), 0x03E0);
  EXPECT_EQ(rgb15From24(0x0000FF), 0x7C00);
  EXPECT_EQ(rgb15From24(0xFFFFFF), 0x7FFF);
}

TEST(Colours, EveryWordOfTheBoardComesBackExactly) {
  for (int word = 0; word <= 0x7FFF; ++word)
    ASSERT_EQ(rgb15From24(rgb24From15(static_cast<std::uint16_t>(word))), word);
  EXPECT_EQ(rgb24From15(0x7FFF), 0xFFFFFF);
}

}  // namespace
}  // namespace darwinop
