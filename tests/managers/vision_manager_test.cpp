// Vision manager under both class names.
#include <gmock/gmock.h>

#include <DARwInOPVisionManager.hpp>
#include <RobotisOp2VisionManager.hpp>

#include "managers/vision/pictures.hpp"
#include "webots/notices.hpp"

namespace darwinop::webots_api {
namespace {

using managers::DARwInOPVisionManager;
using managers::RobotisOp2VisionManager;
using testing::HasSubstr;
using vision::kGreen;
using vision::kRed;
using vision::Picture;

template <class Manager>
class VisionManager : public testing::Test {
 protected:
  VisionManager() {
    forgetWarnings();
    testing::internal::CaptureStderr();
  }
  ~VisionManager() override {
    if (!logged_) {
      EXPECT_EQ(logged(), "") << "unexpected message";
    }
  }
  std::string logged() {
    logged_ = true;
    return testing::internal::GetCapturedStderr();
  }
  static Manager makeRedFinder() { return Manager{40, 30, 0, 15, 60, 15, 0, 50}; }

  /// Whether a ball was found; if not, the coordinates must be 0, 0.
  bool found(DARwInOPVisionManager& manager, const Picture& picture) {
    x = y = -7;
    const bool there = manager.getBallCenter(x, y, picture.data());
    if (!there) {
      EXPECT_TRUE(x == 0 && y == 0);
    }
    return there;
  }

  double x = -7, y = -7;
  Picture ball = Picture{40, 30}.box(10, 20, 4, 5);

 private:
  bool logged_ = false;
};

using Names = testing::Types<DARwInOPVisionManager, RobotisOp2VisionManager>;
TYPED_TEST_SUITE(VisionManager, Names);

TYPED_TEST(VisionManager, FindsABallInIntegerPixels) {
  TypeParam manager = this->makeRedFinder();
  EXPECT_TRUE(this->found(manager, this->ball));
  EXPECT_EQ(this->x, 11);
  EXPECT_EQ(this->y, 22);
  EXPECT_TRUE(manager.isDetected(10, 20));
  EXPECT_TRUE(manager.isDetected(13, 24));
  EXPECT_FALSE(manager.isDetected(14, 24));
}

TYPED_TEST(VisionManager, WithoutABallBothCoordinatesAreZero) {
  TypeParam manager = this->makeRedFinder();
  EXPECT_FALSE(this->found(manager, Picture(40, 30)));
}

TYPED_TEST(VisionManager, ANullImageIsReportedOnceAndNothingIsFound) {
  TypeParam manager = this->makeRedFinder();
  EXPECT_TRUE(this->found(manager, this->ball));
  for (int i = 0; i < 3; ++i) EXPECT_FALSE(manager.getBallCenter(this->x, this->y, nullptr));
  EXPECT_TRUE(this->x == 0 && this->y == 0);
  EXPECT_FALSE(manager.isDetected(11, 22)) << "the earlier result is cleared";
  EXPECT_EQ(this->logged(), "darwinop: VisionManager: the image of getBallCenter() is null; enable the camera\n");
}

TYPED_TEST(VisionManager, NothingIsDetectedOutsideOfTheImageOrBeforeTheFirst) {
  TypeParam manager = this->makeRedFinder();
  EXPECT_FALSE(manager.isDetected(11, 22));
  manager.setMinPercent(0);
  manager.setmaxPercent(100);
  EXPECT_TRUE(this->found(manager, Picture(40, 30, kRed)));
  EXPECT_TRUE(manager.isDetected(38, 28));
  for (const auto& [column, row] : {std::pair{40, 28}, {38, 30}, {-1, 5}, {5, -1}, {1 << 30, 1 << 30}})
    EXPECT_FALSE(manager.isDetected(column, row)) << column << ' ' << row;
}

TYPED_TEST(VisionManager, SettersApplyFromTheNextImage) {
  TypeParam manager = this->makeRedFinder();
  EXPECT_TRUE(this->found(manager, this->ball));
  // The ball: hue 0, saturation 94, value 78; 20 of 1200 pixels.
  struct {
    void (DARwInOPVisionManager::*set)(int);
    int without, with;
  } const kSetters[] = {
      {&DARwInOPVisionManager::setHue, 180, 10},          {&DARwInOPVisionManager::setHueTolerance, 0, 1},
      {&DARwInOPVisionManager::setMinSaturation, 94, 93}, {&DARwInOPVisionManager::setMinValue, 78, 77},
      {&DARwInOPVisionManager::setMinPercent, 2, 1},      {&DARwInOPVisionManager::setmaxPercent, 1, 2},
  };
  manager.setHue(0);
  for (const auto& [set, without, with] : kSetters) {
    (manager.*set)(without);
    EXPECT_FALSE(this->found(manager, this->ball));
    (manager.*set)(with);
    if (set == &DARwInOPVisionManager::setHue) manager.setHue(0);
    EXPECT_TRUE(this->found(manager, this->ball));
  }
}

TYPED_TEST(VisionManager, ValuesOutOfRangeAreReportedOnceAndAdjusted) {
  TypeParam manager{40, 30, -5, 200, -9, 101, -1, 400};
  manager.setHue(-5);
  const std::string said = this->logged();
  for (const char* what : {"hue is out of range and was adjusted to 0 to 360: the same direction\n",
                           "hue tolerance is out of range and was adjusted to 0 to 180",
                           "minimum saturation is out of range and was adjusted to -1 to 100",
                           "minimum value is out of range and was adjusted to -1 to 100",
                           "minimum percent is out of range and was adjusted to 0 to 100",
                           "maximum percent is out of range and was adjusted to 0 to 100"})
    EXPECT_THAT(said, HasSubstr(what));
  EXPECT_EQ(std::ranges::count(said, '\n'), 6) << said;
  manager.setHueTolerance(15);
  manager.setMinValue(15);
  EXPECT_TRUE(this->found(manager, this->ball)) << "-5 degrees is 355";
}

TYPED_TEST(VisionManager, MinusOneAcceptsGreyAsHue15) {
  TypeParam manager{40, 30, 15, 3, -1, -1, 0, 100};
  EXPECT_TRUE(this->found(manager, Picture{40, 30}.box(5, 5, 10, 10, {90, 90, 90})));
  manager.setMinValue(0);
  EXPECT_FALSE(this->found(manager, Picture{40, 30}.box(5, 5, 10, 10, {90, 90, 90})));
}

TYPED_TEST(VisionManager, AnInvalidSizeIsReportedAndNothingIsFound) {
  TypeParam manager{0, 30, 0, 15, 60, 15, 0, 50};
  EXPECT_FALSE(this->found(manager, this->ball));
  EXPECT_FALSE(manager.isDetected(0, 0));
  EXPECT_THAT(this->logged(),
              HasSubstr("VisionManager: the width of an image is 0 pixels; must be 1 to 16384; nothing will"));
}

TYPED_TEST(VisionManager, ACopyIsIndependent) {
  TypeParam manager = this->makeRedFinder();
  EXPECT_TRUE(this->found(manager, this->ball));
  TypeParam copy{manager}, assigned{10, 10, 100, 1, 0, 0, 0, 1};
  assigned = manager;
  manager.setHue(180);
  EXPECT_FALSE(this->found(manager, this->ball));
  EXPECT_TRUE(copy.isDetected(11, 22)) << "the copied result";
  for (TypeParam* other : {&copy, &assigned}) {
    EXPECT_TRUE(this->found(*other, this->ball));
    other->setHue(180);
    EXPECT_FALSE(this->found(*other, this->ball));
  }
  TypeParam of_cyan{manager};
  of_cyan.setMinPercent(0);
  EXPECT_FALSE(this->found(of_cyan, this->ball)) << "one setting changed, the copied ones are kept";
  TypeParam& itself = manager;
  manager = itself;
  manager.setHue(0);
  EXPECT_TRUE(this->found(manager, this->ball));
}

TYPED_TEST(VisionManager, DoesNotKeepTheImage) {
  auto image = std::make_unique<Picture>(this->ball);
  {
    TypeParam manager = this->makeRedFinder();
    EXPECT_TRUE(this->found(manager, *image));
    image = std::make_unique<Picture>(40, 30);
    EXPECT_TRUE(manager.isDetected(11, 22)) << "the mask is a copy";
  }
  EXPECT_EQ(image->bytes().size(), 4u * 40 * 30);
}

TYPED_TEST(VisionManager, IsDestroyedThroughItsBase) {
  std::unique_ptr<DARwInOPVisionManager> manager = std::make_unique<TypeParam>(40, 30, 0, 15, 60, 15, 0, 50);
  EXPECT_TRUE(this->found(*manager, this->ball));
}

// Arguments of the simulator's examples: red ball of visual tracking, orange ball of soccer.
TYPED_TEST(VisionManager, FindsTheBallsOfTheExamples) {
  TypeParam red{40, 30, 355, 15, 60, 15, 0, 30}, orange{40, 30, 28, 20, 50, 45, 0, 30};
  const Picture orange_ball = Picture{40, 30}.box(20, 10, 6, 6, {230, 120, 20});
  EXPECT_TRUE(this->found(red, this->ball));
  EXPECT_FALSE(this->found(red, orange_ball));
  EXPECT_TRUE(this->found(orange, orange_ball));
  EXPECT_FALSE(this->found(orange, this->ball));
}

}  // namespace
}  // namespace darwinop::webots_api
