// Every fault of the virtual camera: what is said, that it is said once, and that all is well when it is over.
#include "hal/camera_v4l2/bench.hpp"

namespace darwinop::v4l2 {
namespace {

struct FaultRow {
  const char* name;
  CameraFault fault;
  const char* words;
};

std::ostream& operator<<(std::ostream& out, const FaultRow& row) {
  return out << row.name;
}

struct FaultTest : testing::TestWithParam<FaultRow> {
  VirtualCamera device;
  Ears ears;

  void expectSaidOnceAndOver(Camera& camera, std::uint64_t last) {
    ASSERT_TRUE(ears.hears(GetParam().words)) << testing::PrintToString(ears.heard());
    std::this_thread::sleep_for(150ms);  // many more attempts, or another stretch of it
    EXPECT_EQ(ears.heard().size(), 1u) << testing::PrintToString(ears.heard());
    EXPECT_THAT(ears.heard().front(), testing::EndsWith("; it is tried again until it works"));
    device.fault(CameraFault::kNone);
    EXPECT_TRUE(ears.hears("the camera at /dev/video0 is back"));
    EXPECT_EQ(wrongPixels(waitForPicture(camera, last), 1), 0);
    EXPECT_EQ(ears.heard().size(), 2u) << testing::PrintToString(ears.heard());
  }
};

using AtOpening = FaultTest;
TEST_P(AtOpening, IsToldOnceAndEnds) {
  device.fault(GetParam().fault);
  Camera camera{inAHurry(ears)};
  ASSERT_TRUE(ears.hears(GetParam().words)) << testing::PrintToString(ears.heard());
  EXPECT_EQ(camera.newest().sequence, 0u);
  EXPECT_EQ(camera.health().frames, 0u);
  EXPECT_FALSE(camera.health().seeing);
  expectSaidOnceAndOver(camera, 0);
}

INSTANTIATE_TEST_SUITE_P(
    Camera, AtOpening,
    testing::Values(FaultRow{"Absent", CameraFault::kGone, "there is no camera at /dev/video0; "},
                    FaultRow{"NoAccess", CameraFault::kNoAccess, "run `sudo usermod -aG video $USER`"},
                    FaultRow{"Busy", CameraFault::kBusy, "find it with `sudo fuser -v /dev/video0`"},
                    FaultRow{"OtherFormat", CameraFault::kOtherFormat, "gives pictures as MJPG, only YUYV can be used"},
                    FaultRow{"OneBuffer", CameraFault::kOneBuffer, "grants a single buffer, two are needed"},
                    FaultRow{"NoMmap", CameraFault::kNoMmap, "cannot hand over pictures in mapped memory"},
                    FaultRow{"Silent", CameraFault::kSilent, "sends no pictures: unplug it"},
                    FaultRow{"Short", CameraFault::kShort, "sends only damaged pictures"},
                    FaultRow{"Flagged", CameraFault::kFlagged, "sends only damaged pictures"}),
    [](const auto& tested) { return std::string{tested.param.name}; });

using AmidPictures = FaultTest;
TEST_P(AmidPictures, IsToldOnceAndEnds) {
  Camera camera{inAHurry(ears)};
  waitForPicture(camera);
  device.fault(GetParam().fault);
  ASSERT_TRUE(ears.hears(GetParam().words)) << testing::PrintToString(ears.heard());
  expectSaidOnceAndOver(camera, camera.newest().sequence);
  EXPECT_GT(camera.health().reopened, 0u);
}

INSTANTIATE_TEST_SUITE_P(Camera, AmidPictures,
                         testing::Values(FaultRow{"Gone", CameraFault::kGone, "the camera at /dev/video0 is gone"},
                                         FaultRow{"Silent", CameraFault::kSilent, "sends no pictures: unplug it"},
                                         FaultRow{"Short", CameraFault::kShort,
                                                  "sends only damaged pictures: check its USB cable"},
                                         FaultRow{"Flagged", CameraFault::kFlagged, "sends only damaged pictures"},
                                         FaultRow{"IoError", CameraFault::kIoError, "sends only damaged pictures"}),
                         [](const auto& tested) { return std::string{tested.param.name}; });

using Faults = FaultTest;

TEST_F(Faults, ThatAreShortAreCountedAndNeverShown) {
  Camera camera{inAHurry(ears)};
  waitForPicture(camera);
  device.fault(CameraFault::kShort);
  ASSERT_TRUE(waitFor([&] { return camera.health().damaged >= 2; }));
  const std::uint64_t last = camera.newest().sequence;
  ASSERT_TRUE(waitFor([&] { return camera.health().damaged >= 5; }));
  EXPECT_EQ(camera.newest().sequence, last);
  EXPECT_EQ(wrongPixels(camera.newest(), 1), 0);
}

TEST_F(Faults, OfReadingAtThePaceOfPicturesAreDamagedOnes) {
  CameraOptions options = inAHurry(ears);
  options.patience.silent = 60s;
  Camera camera{options};
  waitForPicture(camera);
  device.fault(CameraFault::kIoError);
  ASSERT_TRUE(waitFor([&] { return camera.health().damaged >= 15; }));
  device.fault(CameraFault::kNone);
  ASSERT_TRUE(waitForFrames(camera, 2));
  EXPECT_EQ(camera.health().reopened, 0u);
  EXPECT_THAT(ears.heard(), testing::IsEmpty());
}

TEST_F(Faults, ThatSlowACameraDownAreNone) {
  device.fault(CameraFault::kSlow);
  Camera camera{inAHurry(ears)};
  EXPECT_TRUE(waitForFrames(camera, 4));
  EXPECT_THAT(ears.heard(), testing::IsEmpty());
  EXPECT_EQ(camera.health().dropped, 0u);
}

TEST_F(Faults, ThatLosePicturesAreCounted) {
  device.fault(CameraFault::kDrops);
  Camera camera{inAHurry(ears)};
  ASSERT_TRUE(waitFor([&] { return camera.health().dropped >= 3; }));
  const std::uint64_t frames = camera.health().frames;
  EXPECT_GE(frames, 5u);
  EXPECT_GT(waitForPicture(camera).sequence, frames);
  EXPECT_THAT(ears.heard(), testing::IsEmpty());
}

}  // namespace
}  // namespace darwinop::v4l2
