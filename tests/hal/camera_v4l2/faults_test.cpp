// Every fault of the virtual camera: message, reported once, recovery.
#include "hal/camera_v4l2/bench.hpp"
#include "hal/camera_v4l2/buffers.hpp"

namespace darwinop::v4l2 {
namespace {

struct FaultRow {
  const char* name;
  CameraFault fault;
  CameraError error;
  const char* detail = "";
};

std::ostream& operator<<(std::ostream& out, const FaultRow& row) {
  return out << row.name;
}

struct FaultTest : testing::TestWithParam<FaultRow> {
  VirtualCamera device;
  LogCapture log;
  static std::string message() { return messageOf(GetParam().error, GetParam().detail); }

  void expectSaidOnceAndOver(Camera& camera, std::uint64_t last) {
    ASSERT_TRUE(log.receives(message())) << testing::PrintToString(log.lines());
    std::this_thread::sleep_for(150ms);  // many attempts, or more of the fault
    EXPECT_EQ(log.lines().size(), 1u) << testing::PrintToString(log.lines());
    EXPECT_THAT(log.lines().front(), testing::EndsWith("; retrying"));
    device.fault(CameraFault::kNone);
    EXPECT_TRUE(log.receives(messageOfReturn()));
    EXPECT_EQ(wrongPixels(waitForPicture(camera, last), 1), 0);
    EXPECT_EQ(log.lines().size(), 2u) << testing::PrintToString(log.lines());
  }
};

using AtOpening = FaultTest;
TEST_P(AtOpening, IsReportedOnceAndEnds) {
  device.fault(GetParam().fault);
  Camera camera{fastOptions(log)};
  ASSERT_TRUE(log.receives(message())) << testing::PrintToString(log.lines());
  EXPECT_EQ(camera.newest().sequence, 0u);
  EXPECT_EQ(camera.health().frames, 0u);
  EXPECT_FALSE(camera.health().seeing);
  expectSaidOnceAndOver(camera, 0);
}

INSTANTIATE_TEST_SUITE_P(
    Camera, AtOpening,
    testing::Values(FaultRow{"Absent", CameraFault::kGone, CameraError::kAbsent},
                    FaultRow{"NoAccess", CameraFault::kNoAccess, CameraError::kForbidden},
                    FaultRow{"Busy", CameraFault::kBusy, CameraError::kBusy},
                    FaultRow{"OtherFormat", CameraFault::kOtherFormat, CameraError::kOtherFormat, "MJPG"},
                    FaultRow{"OneBuffer", CameraFault::kOneBuffer, CameraError::kFewBuffers, StreamBuffers::kOneBuffer},
                    FaultRow{"NoMmap", CameraFault::kNoMmap, CameraError::kNoStreaming},
                    FaultRow{"Silent", CameraFault::kSilent, CameraError::kSilent},
                    FaultRow{"Short", CameraFault::kShort, CameraError::kDamaged},
                    FaultRow{"Flagged", CameraFault::kFlagged, CameraError::kDamaged}),
    [](const auto& tested) { return std::string{tested.param.name}; });

using AmidPictures = FaultTest;
TEST_P(AmidPictures, IsReportedOnceAndEnds) {
  Camera camera{fastOptions(log)};
  waitForPicture(camera);
  device.fault(GetParam().fault);
  ASSERT_TRUE(log.receives(message())) << testing::PrintToString(log.lines());
  expectSaidOnceAndOver(camera, camera.newest().sequence);
  EXPECT_GT(camera.health().reopened, 0u);
}

INSTANTIATE_TEST_SUITE_P(Camera, AmidPictures,
                         testing::Values(FaultRow{"Gone", CameraFault::kGone, CameraError::kUnplugged},
                                         FaultRow{"Silent", CameraFault::kSilent, CameraError::kSilent},
                                         FaultRow{"Short", CameraFault::kShort, CameraError::kDamaged},
                                         FaultRow{"Flagged", CameraFault::kFlagged, CameraError::kDamaged},
                                         FaultRow{"IoError", CameraFault::kIoError, CameraError::kDamaged}),
                         [](const auto& tested) { return std::string{tested.param.name}; });

using Faults = FaultTest;

TEST_F(Faults, OfShortPicturesAreCountedAndNeverShown) {
  Camera camera{fastOptions(log)};
  waitForPicture(camera);
  device.fault(CameraFault::kShort);
  ASSERT_TRUE(waitFor([&] { return camera.health().damaged >= 2; }));
  const std::uint64_t last = camera.newest().sequence;
  ASSERT_TRUE(waitFor([&] { return camera.health().damaged >= 5; }));
  EXPECT_EQ(camera.newest().sequence, last);
  EXPECT_EQ(wrongPixels(camera.newest(), 1), 0);
}

TEST_F(Faults, OfReadingAtThePictureRateCountAsDamage) {
  CameraOptions options = fastOptions(log);
  options.patience.silent = 60s;
  Camera camera{options};
  waitForPicture(camera);
  device.fault(CameraFault::kIoError);
  ASSERT_TRUE(waitFor([&] { return camera.health().damaged >= 15; }));
  device.fault(CameraFault::kNone);
  ASSERT_TRUE(waitForFrames(camera, 2));
  EXPECT_EQ(camera.health().reopened, 0u);
  EXPECT_THAT(log.lines(), testing::IsEmpty());
}

TEST_F(Faults, OfASlowCameraAreNotReported) {
  device.fault(CameraFault::kSlow);
  Camera camera{fastOptions(log)};
  EXPECT_TRUE(waitForFrames(camera, 4));
  EXPECT_THAT(log.lines(), testing::IsEmpty());
  EXPECT_EQ(camera.health().dropped, 0u);
}

TEST_F(Faults, OfDroppedPicturesAreCounted) {
  device.fault(CameraFault::kDrops);
  Camera camera{fastOptions(log)};
  ASSERT_TRUE(waitFor([&] { return camera.health().dropped >= 3; }));
  const std::uint64_t frames = camera.health().frames;
  EXPECT_GE(frames, 5u);
  EXPECT_GT(waitForPicture(camera).sequence, frames);
  EXPECT_THAT(log.lines(), testing::IsEmpty());
}

}  // namespace
}  // namespace darwinop::v4l2
