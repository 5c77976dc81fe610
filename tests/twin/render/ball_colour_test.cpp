// Colour of the twin's ball, as the vision manager of upstream's examples sees it.
#include <gmock/gmock.h>
#include <mujoco/mujoco.h>

#include <chrono>
#include <stdexcept>
#include <vector>

#include "hal/pixels/bgra_to_yuyv.hpp"
#include "hal/pixels/yuyv_to_bgra.hpp"
#include "managers/vision/colour_finder.hpp"
#include "twin/render/head_camera.hpp"
#include "twin/render/support.hpp"
#include "twin/view/named_poses.hpp"

namespace darwinop::twin {
namespace {

// Arguments of upstream's soccer and visual_tracking examples.
constexpr vision::Thresholds kSoccer{28, 20, 50, 45}, kVisualTracking{355, 15, 60, 15};
constexpr PercentLimits kAnyShare{0, 30};

RobotBody bodyWith(std::optional<BallColour> colour) {
  return RobotBody{readModel(findModel("darwin-op")), {.ball_colour = colour}};
}

/// As a controller gets it from a V4L2 camera.
std::vector<std::uint8_t> throughYuyv(const CameraFrame& frame) {
  const std::size_t stride = pixels::yuyvRowBytes(frame.width);
  std::vector<std::uint8_t> yuyv(stride * static_cast<std::size_t>(frame.height)), bgra(frame.bgra.size());
  pixels::bgraToYuyvRotated(frame.bgra, frame.width, frame.height, yuyv, stride);
  pixels::yuyvToBgraRotated({yuyv, frame.width, frame.height, stride}, bgra);
  return bgra;
}

struct Looks {
  int soccer = 0, soccer_through_yuyv = 0, visual_tracking = 0, all = 0;
};

/// Balls ahead, aside, near and far, seen from the start pose.
Looks looksAt(std::optional<BallColour> colour) {
  RobotBody body = bodyWith(colour);
  HeadCamera camera{body};
  vision::ColourFinder soccer{320, 240, kSoccer, kAnyShare}, visual_tracking{320, 240, kVisualTracking, kAnyShare};
  Looks looks;
  for (const double ahead : {0.3, 0.4, 0.5, 0.55})
    for (const double left : {-0.1, 0.0, 0.1}) {
      body.place(startAngles());
      body.placeBall(ahead, left);
      body.step(std::chrono::milliseconds{34}, Drives{});  // one picture period later
      camera.look();
      const CameraFrame frame = camera.newest();
      EXPECT_EQ(camera.renderError(), nullptr);
      ++looks.all;
      looks.soccer += soccer.find(frame.bgra).has_value() ? 1 : 0;
      looks.soccer_through_yuyv += soccer.find(throughYuyv(frame)).has_value() ? 1 : 0;
      looks.visual_tracking += visual_tracking.find(frame.bgra).has_value() ? 1 : 0;
    }
  return looks;
}

TEST(TwinBall, IsSeenByUpstreamsSoccerExampleByDefault) {
  const Looks looks = looksAt(std::nullopt);
  EXPECT_EQ(looks.soccer, looks.all);
  EXPECT_EQ(looks.soccer_through_yuyv, looks.all);
  EXPECT_EQ(looks.visual_tracking, 0);
}

TEST(TwinBall, HasTheColourOfTheEnvironment) {
  const Environment red{"DARWINOP_TWIN_BALL_COLOUR", "red"};
  const Looks looks = looksAt(ballColourFromEnvironment());
  EXPECT_EQ(looks.soccer, 0);
  EXPECT_EQ(looks.visual_tracking, looks.all);
}

TEST(TwinBall, ColourIsANameOrSixHexDigits) {
  const auto colour_of = [](const std::string& value) {
    const Environment colour{"DARWINOP_TWIN_BALL_COLOUR", value};
    return ballColourFromEnvironment();
  };
  EXPECT_EQ(colour_of(""), std::nullopt);
  EXPECT_EQ(colour_of("#ff0033"), (BallColour{1, 0, 0.2F}));
  ASSERT_TRUE(colour_of("orange"));
  for (const char* wrong : {"orang", "#ff003", "#ff00333", "ff0033", "#ff00g3", "#-f0033"})
    EXPECT_THROW((void)colour_of(wrong), std::runtime_error) << wrong;
}

TEST(TwinBall, NamedOrangeIsTheDefault) {
  const Environment orange{"DARWINOP_TWIN_BALL_COLOUR", "orange"};
  const RobotBody named = bodyWith(ballColourFromEnvironment()), usual = bodyWith(std::nullopt);
  const auto rgba = [](const RobotBody& body) {
    const mjModel& m = *body.mujocoModel();
    const float* const first = m.mat_rgba + std::ptrdiff_t{4} * mj_name2id(&m, mjOBJ_MATERIAL, "ball");
    return BallColour{first[0], first[1], first[2]};
  };
  EXPECT_EQ(rgba(named), rgba(usual));
}

}  // namespace
}  // namespace darwinop::twin
