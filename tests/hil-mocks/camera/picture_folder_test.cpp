// Picture folder: order, size, error messages.
#include "hil-mocks/camera/picture_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <stdexcept>

#include "support/temporary_folder.hpp"

namespace darwinop::hil {
namespace {

using testing::AllOf;
using testing::HasSubstr;

constexpr Colour kRed{255, 0, 0}, kBlue{0, 0, 255};

// 1x1, colour 1 2 3; written by another program.
constexpr unsigned char kPng[] = {0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a, 0x00, 0x00, 0x00, 0x0d, 0x49, 0x48,
                                  0x44, 0x52, 0x00, 0x00, 0x00, 0x01, 0x00, 0x00, 0x00, 0x01, 0x08, 0x02, 0x00, 0x00,
                                  0x00, 0x90, 0x77, 0x53, 0xde, 0x00, 0x00, 0x00, 0x0c, 0x49, 0x44, 0x41, 0x54, 0x78,
                                  0x9c, 0x63, 0x60, 0x64, 0x62, 0x06, 0x00, 0x00, 0x0e, 0x00, 0x07, 0xd7, 0x6f, 0xe4,
                                  0x78, 0x00, 0x00, 0x00, 0x00, 0x49, 0x45, 0x4e, 0x44, 0xae, 0x42, 0x60, 0x82};

void write(const std::string& file, const std::string& text) {
  std::ofstream{file, std::ios::binary} << text;
}

std::string pixels(std::initializer_list<Colour> colours) {
  std::string text;
  for (const Colour& colour : colours) text.append(colour.begin(), colour.end());
  return text;
}

std::string errorOf(const std::string& folder) {
  try {
    const PictureFolder pictures{folder, 1};
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "none";
}

TEST(PictureFolder, ShowsEachPictureForItsFramesInNameOrderAndRepeats) {
  const TemporaryFolder folder;
  write(folder / "2.ppm", "P6 1 1 255\n" + pixels({kBlue}));
  write(folder / "1.PPM", "P6\n# drawn by hand\n1 1\n255\n" + pixels({kRed}));
  write(folder / "notes.txt", "not a picture");
  const PictureFolder pictures{folder / ".", 2};
  ASSERT_EQ(pictures.count(), 2u);
  PaintedPicture shown{4, 2};
  for (const auto& [frame, colour] : {std::pair{0u, kRed}, {1u, kRed}, {2u, kBlue}, {3u, kBlue}, {4u, kRed}}) {
    pictures.draw(shown, frame);
    EXPECT_EQ(shown.colour(0, 0), colour) << frame;
    EXPECT_EQ(shown.colour(3, 1), colour) << frame;
  }
}

TEST(PictureFolder, ScalesByTheNearestPixel) {
  const TemporaryFolder folder;
  write(folder / "a.ppm", "P6 2 1 255\n" + pixels({kRed, kBlue}));
  PaintedPicture shown{6, 2};
  PictureFolder{folder / ".", 1}.draw(shown, 0);
  for (int x = 0; x < 6; ++x) EXPECT_EQ(shown.colour(x, 1), x < 3 ? kRed : kBlue) << x;
}

TEST(PictureFolder, ReadsPng) {
  const TemporaryFolder folder;
  write(folder / "a.png", std::string{reinterpret_cast<const char*>(kPng), sizeof kPng});
  PaintedPicture shown{2, 2};
  PictureFolder{folder / ".", 1}.draw(shown, 0);
  EXPECT_EQ(shown.colour(1, 1), (Colour{1, 2, 3}));
}

TEST(PictureFolder, ReportsARemedyForAFolderWithoutPictures) {
  const TemporaryFolder folder;
  EXPECT_THAT(errorOf(folder / "."), AllOf(HasSubstr(folder / "."), HasSubstr(".png"), HasSubstr(".ppm")));
  EXPECT_THAT(errorOf(folder / "none"), AllOf(HasSubstr(folder / "none"), HasSubstr(std::strerror(ENOENT))));
}

TEST(PictureFolder, DoesNotWaitForAPipe) {
  const TemporaryFolder folder;
  ASSERT_EQ(mkfifo((folder / "pipe.ppm").c_str(), 0600), 0);
  EXPECT_THAT(errorOf(folder / "."), AllOf(HasSubstr("pipe.ppm"), HasSubstr(kNotRegularFile)));
}

TEST(PictureFolder, NamesADamagedPicture) {
  for (const std::string text : {"P6 2 2 255\nshort", "P5 1 1 255\nx", "P6 1 1 65535\nabcdef", "P6 0 1 255\n", ""}) {
    const TemporaryFolder folder;
    write(folder / "bad.ppm", text);
    EXPECT_THAT(errorOf(folder / "."), HasSubstr(folder / "./bad.ppm")) << text;
  }
  const TemporaryFolder folder;
  write(folder / "bad.png", "no png");
  EXPECT_THAT(errorOf(folder / "."), AllOf(HasSubstr(folder / "./bad.png"), HasSubstr(kSavePngAgain)));
}

}  // namespace
}  // namespace darwinop::hil
