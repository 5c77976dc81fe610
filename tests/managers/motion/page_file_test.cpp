// Motion file: lossless conversion, and error messages with page and byte.
#include "managers/motion/page_file.hpp"

#include <gmock/gmock.h>

#include <functional>

#include "managers/motion/pages.hpp"

namespace darwinop::motion {
namespace {

using testing::HasSubstr;

using Bytes = std::vector<std::uint8_t>;

Bytes validFile() {
  PageFile pages = emptyFile();
  pages[12] = pageOf({stepTo(2000, 25), stepTo(2100, 25)});
  return encodePages(pages);
}

/// Error message for a file with one changed page, with or without a corrected checksum.
std::string sentenceAbout(std::size_t page, const std::function<void(std::uint8_t*)>& change, bool sealed = true) {
  Bytes bytes = validFile();
  std::uint8_t* const at = bytes.data() + page * kPageBytes;
  change(at);
  if (sealed) {
    unsigned sum = 0;
    for (std::size_t i = 0; i < kPageBytes; ++i) sum += i == 31 ? 0U : at[i];
    at[31] = static_cast<std::uint8_t>(0xFF - sum);
  }
  try {
    (void)decodePages(bytes);
  } catch (const std::runtime_error& why) {
    return why.what();
  }
  return "it is accepted";
}

TEST(PageFile, FieldsHaveTheOffsetsOfTheFormat) {
  Bytes bytes(kFileBytes);
  for (std::size_t page = 1; page < kPages; ++page) bytes[page * kPageBytes + 31] = 0xFF;
  std::uint8_t* const page = bytes.data() + 3 * kPageBytes;
  const std::pair<std::size_t, std::uint8_t> kGiven[] = {
      {0, 'r'},   {1, 'k'},   {15, 4},    {16, 10},   {20, 2},    {22, 21},  {24, 30},  {25, 7},  {26, 9},
      {33, 0x77}, {64, 0x34}, {65, 0x02}, {66, 0xFF}, {67, 0x0F}, {126, 25}, {127, 50}, {511, 99}};
  for (const auto& [at, value] : kGiven) {
    page[at] = value;
    page[31] = static_cast<std::uint8_t>(page[31] - value);
  }
  const Page seen = decodePages(bytes)[3];
  EXPECT_EQ(seen.nameText(), "rk");
  EXPECT_EQ(seen.repeat, 4);
  EXPECT_EQ(seen.schedule, kTimeBased);
  EXPECT_EQ(seen.steps, 2);
  EXPECT_EQ(seen.speed, 21);
  EXPECT_EQ(seen.acceleration, 30);
  EXPECT_EQ(seen.next, 7);
  EXPECT_EQ(seen.exit, 9);
  EXPECT_EQ(seen.slopes[1], 0x77);
  EXPECT_EQ(seen.step[0].position[0], 0x234);
  EXPECT_EQ(seen.step[0].position[1], 0xFFF);
  EXPECT_EQ(seen.step[0].pause, 25);
  EXPECT_EQ(seen.step[0].time, 50);
  EXPECT_EQ(seen.step[6].time, 99);
}

TEST(PageFile, AnyFileIsUnchangedByReadingAndWriting) {
  std::mt19937 rng{7};
  for (int run = 0; run < 20; ++run) {
    PageFile pages = randomFile(rng);
    pages[0].has_checksum = true;
    const Bytes bytes = encodePages(pages);
    ASSERT_EQ(decodePages(bytes), pages);
    ASSERT_EQ(encodePages(decodePages(bytes)), bytes);
  }
}

TEST(PageFile, PageZeroMayBeAllZeros) {
  Bytes bytes = validFile();
  std::fill_n(bytes.begin(), kPageBytes, std::uint8_t{0});
  const PageFile pages = decodePages(bytes);
  EXPECT_FALSE(pages[0].canPlay());
  EXPECT_EQ(encodePages(pages), bytes);
  bytes[31] = 0xFF;
  EXPECT_EQ(encodePages(decodePages(bytes)), bytes) << "all zeros with a checksum";
}

TEST(PageFile, AnEmptyPageHasTheVendorsChecksum) {
  EXPECT_EQ(encodePages(emptyFile())[5 * kPageBytes + 31], 0xD1);
}

TEST(PageFile, AnySingleWrongByteIsDetected) {
  const Bytes good = validFile();
  for (std::size_t at = 0; at < kPageBytes; ++at) {
    Bytes bad = good;
    bad[12 * kPageBytes + at] ^= 0x10;
    EXPECT_THROW((void)decodePages(bad), std::runtime_error) << at;
  }
}

TEST(PageFile, ErrorsContainPageAndByte) {
  const auto nothing = [](std::uint8_t*) {};
  EXPECT_EQ(sentenceAbout(12, nothing), "it is accepted");
  EXPECT_EQ(sentenceAbout(
                12, [](std::uint8_t* page) { page[70] = static_cast<std::uint8_t>(page[70] + 3); }, false),
            "page 12, byte 6175: wrong checksum: the 512 bytes of the page add up to 0x02 instead of 0xFF");
  EXPECT_EQ(sentenceAbout(12, [](std::uint8_t* page) { page[20] = 8; }),
            "page 12, byte 6164: invalid number of steps 8; must be 0 to 7");
  EXPECT_EQ(sentenceAbout(12, [](std::uint8_t* page) { page[16] = 5; }),
            "page 12, byte 6160: invalid schedule 5; must be 0 (by speed) or 10 (by time)");
  EXPECT_EQ(sentenceAbout(12, [](std::uint8_t* page) { page[22] = 0; }),
            "page 12, byte 6166: invalid speed 0; must be 1 to 255, default 32");
  EXPECT_EQ(sentenceAbout(13, [](std::uint8_t* page) { page[16] = page[22] = 0; }), "it is accepted")
      << "a page without steps is never played";
  EXPECT_THAT(sentenceAbout(
                  0, [](std::uint8_t* page) { page[40] = 1; }, false),
              HasSubstr("page 0, byte 31: "));
  EXPECT_THAT(sentenceAbout(
                  1, [](std::uint8_t* page) { std::fill_n(page, kPageBytes, std::uint8_t{0}); }, false),
              HasSubstr("page 1, byte 543: "))
      << "only page 0 may be all zeros";
}

TEST(PageFile, AWrongLengthIsRefused) {
  for (const std::size_t length : {std::size_t{0}, kPageBytes * 4 + 2, kFileBytes - 1, kFileBytes + 1})
    EXPECT_THROW((void)decodePages(Bytes(length)), std::runtime_error) << length;
  EXPECT_THROW((void)encodePages(PageFile(255)), std::invalid_argument);
}

TEST(PageFile, AMessageAboutTheLengthNamesPageAndByte) {
  const auto sentence = [](std::size_t length) {
    try {
      (void)decodePages(Bytes(length));
    } catch (const std::runtime_error& why) {
      return std::string{why.what()};
    }
    return std::string{};
  };
  EXPECT_THAT(sentence(1030), HasSubstr("page 2, at byte 1030"));
  EXPECT_THAT(sentence(kFileBytes + 9), HasSubstr("131072"));
}

TEST(PageFile, SlopesAreConvertedToGains) {
  const std::pair<std::uint8_t, int> kGains[] = {{0x44, 64}, {0x55, 32}, {0x66, 16},
                                                 {0x77, 8},  {0x57, 32}, {0x00, 254}};
  for (const auto& [slopes, gain] : kGains) EXPECT_EQ(pGainRegister(slopes), gain) << int{slopes};
}

}  // namespace
}  // namespace darwinop::motion
