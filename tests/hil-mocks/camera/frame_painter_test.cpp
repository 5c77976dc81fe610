// Frame file: written and read by the painter.
#include "hil-mocks/camera/frame_painter.hpp"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/mman.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <memory>
#include <stdexcept>

#include "hil-mocks/camera/camera_fault.hpp"
#include "support/temporary_folder.hpp"

namespace darwinop::hil {
namespace {

/// The file as mapped by a camera.
struct Mapped {
  explicit Mapped(const std::string& path) {
    const int fd = open(path.c_str(), O_RDWR | O_CLOEXEC);
    void* const memory = mmap(nullptr, kFrameFileSize, PROT_READ | PROT_WRITE, MAP_SHARED, fd, 0);
    close(fd);
    if (memory == MAP_FAILED) throw std::runtime_error("cannot map " + path);  // no message
    file = static_cast<FrameFile*>(memory);
  }
  ~Mapped() { munmap(file, kFrameFileSize); }
  Mapped(const Mapped&) = delete;
  Mapped& operator=(const Mapped&) = delete;
  [[nodiscard]] std::uint8_t byte(std::uint32_t picture, std::uint32_t at) const {
    return reinterpret_cast<const std::uint8_t*>(file)[pictureAt(picture) + at];
  }
  FrameFile* file = nullptr;
};

std::vector<std::uint8_t> yuyv(PictureSize size, std::uint8_t value) {
  return std::vector<std::uint8_t>(2 * static_cast<std::size_t>(size.width * size.height), value);
}

TEST(FramePainter, CreatesAValidFileAndRemovesIt) {
  const TemporaryFolder folder;
  {
    const FramePainter painter{folder / "camera"};
    const Mapped camera{folder / "camera"};
    EXPECT_EQ(camera.file->magic, kFrameFileMagic);
    EXPECT_EQ(camera.file->version, kFrameFileVersion);
    EXPECT_EQ(camera.file->pictures, 0u);
    EXPECT_EQ(painter.wanted(), (PictureSize{320, 240}));
  }
  EXPECT_TRUE(std::filesystem::is_empty(folder / "."));
}

TEST(FramePainter, DoesNotModifyThePreviousPicture) {
  const TemporaryFolder folder;
  FramePainter painter{folder / "camera"};
  const Mapped camera{folder / "camera"};
  painter.paintYuyv({320, 240}, yuyv({320, 240}, 11));
  ASSERT_EQ(camera.file->pictures, 1u);
  painter.paintYuyv({640, 480}, yuyv({640, 480}, 22));
  ASSERT_EQ(camera.file->pictures, 2u);
  EXPECT_EQ(camera.byte(1, 0), 11);
  EXPECT_EQ(camera.byte(1, 2 * 320 * 240 - 1), 11);
  EXPECT_EQ(camera.byte(2, 2 * 640 * 480 - 1), 22);
  EXPECT_EQ(camera.file->width[1], 320u);
  EXPECT_EQ(camera.file->width[0], 640u);
  EXPECT_EQ(camera.file->height[0], 480u);
}

TEST(FramePainter, RotatesAnUprightPicture) {
  const TemporaryFolder folder;
  FramePainter painter{folder / "camera"};
  const Mapped camera{folder / "camera"};
  std::vector<std::uint8_t> bgra(4 * 4 * 2, 0);
  for (std::size_t i = 0; i < 8; ++i) bgra[i] = 255;  // the two upper left pixels are white
  painter.paint({4, 2}, bgra);
  EXPECT_EQ(camera.byte(1, 0), 0);
  EXPECT_EQ(camera.byte(1, 4 * 2 * 2 - 4), 255);  // Y of the last pair but one pixel
  EXPECT_EQ(camera.byte(1, 4 * 2 * 2 - 2), 255);
}

TEST(FramePainter, ReadsTheRequestedSizeAndSetsTheFault) {
  const TemporaryFolder folder;
  FramePainter painter{folder / "camera"};
  const Mapped camera{folder / "camera"};
  camera.file->wanted_width = 800;
  camera.file->wanted_height = 600;
  EXPECT_EQ(painter.wanted(), (PictureSize{800, 600}));
  camera.file->wanted_width = 100'000;  // not a valid camera
  EXPECT_EQ(painter.wanted().width, kMostWidth);
  painter.setFault(CameraFault::kSilent);
  EXPECT_EQ(camera.file->fault, static_cast<std::uint32_t>(CameraFault::kSilent));
}

TEST(FramePainter, ReplacesAFileThatACameraHasOpen) {
  const TemporaryFolder folder;
  FramePainter first{folder / "camera"};
  first.paintYuyv({320, 240}, yuyv({320, 240}, 11));
  const Mapped camera{folder / "camera"};
  FramePainter second{folder / "camera"};
  EXPECT_EQ(camera.byte(1, 0), 11);
  EXPECT_EQ(Mapped{folder / "camera"}.file->pictures, 0u);
}

TEST(FramePainter, LeavesTheFileOfItsSuccessor) {
  const TemporaryFolder folder;
  auto first = std::make_unique<FramePainter>(folder / "camera");
  {
    const FramePainter second{folder / "camera"};
    first.reset();
    EXPECT_TRUE(std::filesystem::exists(folder / "camera"));
  }
  EXPECT_TRUE(std::filesystem::is_empty(folder / "."));
}

TEST(FramePainter, RejectsPicturesOfWrongSize) {
  const TemporaryFolder folder;
  FramePainter painter{folder / "camera"};
  EXPECT_THROW(painter.paintYuyv({802, 2}, yuyv({802, 2}, 0)), std::invalid_argument);
  EXPECT_THROW(painter.paintYuyv({3, 2}, yuyv({3, 2}, 0)), std::invalid_argument);
  EXPECT_THROW(painter.paintYuyv({320, 240}, yuyv({320, 238}, 0)), std::invalid_argument);
  EXPECT_THROW(painter.paint({320, 240}, yuyv({320, 240}, 0)), std::invalid_argument);
  EXPECT_EQ(painter.painted(), 0u);
}

TEST(FramePainter, KeepsAFileThatIsSomebodyElses) {
  const std::string path = ::testing::TempDir() + "darwinop_own_picture.png";
  std::ofstream{path} << "a picture";
  EXPECT_THROW(FramePainter{path}, std::runtime_error);
  std::string kept;
  std::getline(std::ifstream{path}, kept);
  EXPECT_EQ(kept, "a picture");
  std::filesystem::remove(path);
}

TEST(FramePainter, NamesAFileThatCannotBeCreated) {
  try {
    const FramePainter painter{"/nowhere/camera"};
    FAIL() << "the file was created";
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("/nowhere/camera: No such file or directory"));
  }
}

TEST(CameraFaults, HaveNamesInEnumOrder) {
  std::uint32_t number = 0;
  for (const CameraFaultRow& row : kCameraFaults) EXPECT_EQ(static_cast<std::uint32_t>(row.fault), number++);
  EXPECT_EQ(number, static_cast<std::uint32_t>(CameraFault::kDrops) + 1);
  EXPECT_EQ(cameraFault("silent"), CameraFault::kSilent);
  EXPECT_EQ(cameraFault("sleepy"), std::nullopt);
}

}  // namespace
}  // namespace darwinop::hil
