// Finding and loading the twin's library, with stand-ins for it.
#include "connect/twin_library.hpp"

#include <gmock/gmock.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "hal/body_library.hpp"
#include "support/temporary_folder.hpp"

namespace darwinop::connect {
namespace {

using testing::EndsWith;
using testing::HasSubstr;

constexpr const char* kVariable = "DARWINOP_TWIN_LIBRARY";

class TwinLibrary : public ::testing::Test {
 protected:
  void TearDown() override {
    unsetenv(kVariable);
    unsetenv("DARWINOP_TWIN_SEED");
  }
  static void use(const std::string& library) { setenv(kVariable, library.c_str(), 1); }
  static std::string refusal(const std::string& model = "") {
    try {
      makeTwin(model, 1);
      return "nothing was refused";
    } catch (const std::runtime_error& wrong) {
      return wrong.what();
    }
  }
};

TEST_F(TwinLibrary, GivesABodyThatIsDrivenAndLookedAt) {
  use(DARWINOP_TWIN_STAND_IN);
  const std::unique_ptr<Body> body = makeTwin("", 7);
  Drives drives;
  drives[kJoints - 1].goal_rad = 0.25;
  body->step(std::chrono::milliseconds{3}, drives);
  EXPECT_EQ(body->state().joint[kJoints - 1].position_rad, 0.25);
  EXPECT_EQ(body->state().gyro_rad_s[0], 3e6);
  EXPECT_EQ(body->state().joint[0].temperature_c, 7) << "the seed";
}

TEST_F(TwinLibrary, GivesACameraThatCapturesOnRequest) {
  use(DARWINOP_TWIN_STAND_IN);
  const std::unique_ptr<Body> body = makeTwin("", 1);
  const std::unique_ptr<BodyCamera> camera = body->openCamera(1, 1);
  camera->look();
  for (int again = 0; again < 2; ++again) {
    const CameraFrame frame = camera->newest();
    EXPECT_EQ(frame.sequence, 1U);
    EXPECT_EQ(frame.time, Nanos{1000});
    ASSERT_EQ(frame.bgra.size(), 4U);
    EXPECT_EQ(frame.bgra[0], 1);
  }
  EXPECT_TRUE(camera->health().seeing);
  EXPECT_EQ(camera->renderError(), nullptr);
  EXPECT_EQ(camera->health().frames, 1U);
  camera->look();
  camera->look();
  EXPECT_EQ(camera->newest().sequence, 3U);
  EXPECT_FALSE(camera->health().seeing) << "the library says that they are blind";
  EXPECT_STREQ(camera->renderError(), "it is dark");
}

TEST_F(TwinLibrary, SaysWhyItGivesNoEyes) {
  use(DARWINOP_TWIN_STAND_IN);
  const std::unique_ptr<Body> body = makeTwin("", 1);
  EXPECT_THAT([&] { (void)body->openCamera(2, 1); },
              testing::ThrowsMessage<std::runtime_error>(HasSubstr("these eyes see one pixel")));
}

TEST_F(TwinLibrary, ThatIsNotThereIsLookedForInNamedPlacesAndTheSentenceSaysWhatToDo) {
  use("/nowhere/libdarwinop-twin.so");
  EXPECT_THAT(refusal(), HasSubstr("/nowhere/libdarwinop-twin.so"));
  EXPECT_THAT(refusal(), HasSubstr("./dev build"));
  EXPECT_THAT(refusal(), HasSubstr(kVariable));
}

TEST_F(TwinLibrary, IsLookedForBesideTheRunningProgramFirst) {
  const std::vector<std::string> places = twinLibraryPlaces();
  ASSERT_GE(places.size(), 2U);
  const auto home = std::filesystem::read_symlink("/proc/self/exe").parent_path();  // as bin beside lib
  EXPECT_EQ(places.front(), home.parent_path() / "lib" / kTwinLibraryFile);
  for (const std::string& place : places) EXPECT_THAT(place, EndsWith("/libdarwinop-twin.so"));
}

TEST_F(TwinLibrary, ThatSomebodyNamedIsTheOnlyOneLookedFor) {
  use("/somewhere/else.so");
  EXPECT_EQ(twinLibraryPlaces(), std::vector<std::string>{"/somewhere/else.so"});
}

TEST_F(TwinLibrary, OfAnotherVersionIsRefusedAndBothAreNamed) {
  use(DARWINOP_TWIN_OF_ANOTHER_VERSION);
  EXPECT_THAT(refusal(), HasSubstr("0.0.7"));
  EXPECT_THAT(refusal(), HasSubstr(DARWINOP_VERSION));
}

TEST_F(TwinLibrary, ThatIsNotALibraryOrNotOursIsRefusedByItsName) {
  const TemporaryFolder folder;
  std::ofstream{folder / "text.so"} << "no library\n";
  use(folder / "text.so");
  EXPECT_THAT(refusal(), HasSubstr(folder / "text.so"));
  use(DARWINOP_SOME_OTHER_LIBRARY);
  EXPECT_THAT(refusal(), HasSubstr("libsome_other_library.so is not a library of the physics twin"));
}

TEST_F(TwinLibrary, ReportsWhyItRefusesAModelInItsOwnWords) {
  use(DARWINOP_TWIN_STAND_IN);
  EXPECT_EQ(refusal("refused"), "refused, line 3: no such key");
}

TEST_F(TwinLibrary, SeedIsANumberOrAReportedMistake) {
  EXPECT_EQ(twinSeed(), 1U);
  setenv("DARWINOP_TWIN_SEED", "18446744073709551615", 1);
  EXPECT_EQ(twinSeed(), 18446744073709551615U);
  for (const char* wrong : {"-1", "1.5", "one", "18446744073709551616"}) {
    setenv("DARWINOP_TWIN_SEED", wrong, 1);
    EXPECT_THROW(twinSeed(), std::runtime_error) << wrong;
  }
}

}  // namespace
}  // namespace darwinop::connect
