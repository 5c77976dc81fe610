// The vendor's pages against recordings of the vendor's engine: every tick, every joint.
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "managers/motion/pages.hpp"

namespace darwinop::motion {
namespace {

struct GoldenRow {
  int start_page, tick, page, step;
  Pose pose;
};

std::vector<GoldenRow> goldenRows() {
  std::ifstream file{DARWINOP_GOLDEN_MOTION};
  std::string line;
  std::getline(file, line);
  std::vector<GoldenRow> rows;
  while (std::getline(file, line)) {
    std::istringstream fields{line};
    GoldenRow row{};
    char comma = 0;
    fields >> row.start_page >> comma >> row.tick >> comma >> row.page >> comma >> row.step;
    for (int& ticks : row.pose) fields >> comma >> ticks;
    EXPECT_TRUE(fields) << line;
    rows.push_back(row);
  }
  return rows;
}

/// Initial pose of the recordings: the pose of page 9.
Pose walkReady(const PageFile& pages) {
  Pose pose;
  for (std::size_t i = 0; i < kJoints; ++i) pose[i] = pages[9].step[0].position[i + 1];
  return pose;
}

TEST(GoldenMotion, EveryTickOfEveryJointEqualsTheVendors) {
  if (!exists(vendorsFile())) GTEST_SKIP() << "the vendor's pages are not available: " << vendorsFile();
  const PageFile pages = vendorsPages();
  const std::vector<GoldenRow> rows = goldenRows();
  ASSERT_EQ(rows.size(), 1777u);
  Player player{pages};
  for (const GoldenRow& row : rows) {
    if (row.tick == 0) {
      ASSERT_FALSE(player.tick()) << "the page before " << row.start_page << " should have ended";
      ASSERT_TRUE(player.start(row.start_page, walkReady(pages)));
    }
    ASSERT_TRUE(player.tick()) << row.start_page << ' ' << row.tick;
    ASSERT_EQ(player.pose(), row.pose) << row.start_page << ' ' << row.tick;
    ASSERT_EQ(player.page(), row.page) << row.start_page << ' ' << row.tick;
    ASSERT_EQ(player.step(), row.step) << row.start_page << ' ' << row.tick;
  }
  EXPECT_FALSE(player.tick());
}

// Source: the vendor's engine, one call per tick, including following pages.
TEST(GoldenMotion, EveryPageHasTheVendorsDuration) {
  if (!exists(vendorsFile())) GTEST_SKIP() << "the vendor's pages are not available: " << vendorsFile();
  const PageFile pages = vendorsPages();
  struct {
    int page, ms;
  } const kDurations[] = {{1, 2048},   {2, 2720},  {3, 2720},   {4, 3704},   {6, 7584},   {9, 1024},
                          {10, 3320},  {11, 4368}, {12, 1840},  {13, 1840},  {15, 1024},  {16, 1024},
                          {17, 20480}, {23, 2056}, {24, 8456},  {27, 3320},  {29, 3600},  {38, 7960},
                          {41, 17456}, {54, 6256}, {57, 2864},  {58, 1520},  {70, 1032},  {71, 1032},
                          {90, 4096},  {91, 3072}, {237, 2016}, {239, 6208}, {240, 4864}, {241, 3840}};
  for (const auto& [page, ms] : kDurations) {
    Player player{pages};
    ASSERT_TRUE(player.start(page, walkReady(pages)));
    int ticks = 0;
    while (player.tick()) ++ticks;
    EXPECT_EQ(ticks * kTickMs, ms) << "page " << page;
  }
}

TEST(GoldenMotion, TheVendorsFileIsUnchangedByReadingAndWriting) {
  if (!exists(vendorsFile())) GTEST_SKIP() << "the vendor's pages are not available: " << vendorsFile();
  std::ifstream file{vendorsFile(), std::ios::binary};
  const std::vector<std::uint8_t> bytes{std::istreambuf_iterator<char>{file}, {}};
  const PageFile pages = decodePages(bytes);
  EXPECT_EQ(encodePages(pages), bytes);
  EXPECT_EQ(pages[255], emptyPage());
  EXPECT_EQ(pages[12].nameText(), "rk");
  EXPECT_EQ(pages[15].nameText(), "sit down");  // no message
  EXPECT_EQ(pGainRegister(pages[12].slopes[15]), 64);
  EXPECT_EQ(pGainRegister(pages[12].slopes[3]), 8);
}

}  // namespace
}  // namespace darwinop::motion
