// Where model files are looked for.
#include <gmock/gmock.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "support/temporary_folder.hpp"
#include "twin/model/texts.hpp"

namespace darwinop::twin {
namespace {

namespace fs = std::filesystem;
using testing::Contains;
using testing::HasSubstr;

/// A folder with models of its own; everything is as before when it goes.
class OwnModels : public testing::Test {
 protected:
  OwnModels() : was_{fs::current_path()} {}
  ~OwnModels() override {
    unsetenv("DARWINOP_MODELS");
    fs::current_path(was_);
  }
  std::string put(const std::string& name, const std::string& text = kNamed) {
    std::ofstream{folder_ / name} << text;
    return folder_ / name;
  }
  void use() { setenv("DARWINOP_MODELS", (folder_ / "").c_str(), 1); }

  TemporaryFolder folder_;

 private:
  fs::path was_;
};

TEST(FindModel, ShippedOnesAreFoundByName) {
  EXPECT_TRUE(fs::equivalent(findModel("darwin-op"), DARWINOP_SHIPPED_MODELS "/darwin-op.ini"));
  EXPECT_THAT(shippedModels(), Contains("darwin-op"));
  EXPECT_THAT(shippedModels(), Contains("webots-2013"));
}

TEST(FindModel, AnUnknownNameIsRefusedWithTheShippedOnes) {
  EXPECT_EQ(refusal([] { findModel("darvin-op"); }),
            "there is no model \"darvin-op\"; the shipped models are darwin-op and webots-2013, and a file of your own "
            "is named by its path, as in ./my-robot.ini");
  EXPECT_EQ(refusal([] { findModel("/nowhere/my.ini"); }),
            "there is no model file /nowhere/my.ini; the shipped models are darwin-op and webots-2013");
  EXPECT_THAT(refusal([] { findModel(""); }), HasSubstr("there is no model \"\""));
}

TEST_F(OwnModels, AFolderOfTheUserComesBeforeTheShippedOnes) {
  const std::string mine = put("mine.ini"), other = put("darwin-op.ini");
  use();
  EXPECT_TRUE(fs::equivalent(findModel("mine"), mine));
  EXPECT_TRUE(fs::equivalent(findModel("darwin-op"), other));
  EXPECT_THAT(shippedModels(), testing::ElementsAre("darwin-op", "mine", "webots-2013"));
}

TEST_F(OwnModels, APathIsAPath) {
  const std::string mine = put("mine.ini"), bare = put("bare");
  EXPECT_EQ(findModel(mine), mine);
  fs::current_path(folder_ / "");
  EXPECT_EQ(findModel("mine.ini"), "mine.ini");
  EXPECT_EQ(findModel("bare"), "bare");
  fs::create_directory("darwin-op");  // a folder of that name is no model file
  EXPECT_TRUE(fs::equivalent(findModel("darwin-op"), DARWINOP_SHIPPED_MODELS "/darwin-op.ini"));
}

TEST_F(OwnModels, AModelIsReadWithTheBodyThatLiesBesideIt) {
  const std::string mine = put("mine.ini", kNamed + "[body]\nxml = own.xml\n");
  put("own.xml", "<mujoco/>");
  EXPECT_TRUE(fs::equivalent(readModel(mine).folder, folder_ / ""));
}

TEST_F(OwnModels, ACopyOfAShippedModelUsesTheShippedBody) {
  EXPECT_TRUE(fs::equivalent(readModel(put("mine.ini")).folder, DARWINOP_SHIPPED_MODELS));
}

TEST_F(OwnModels, AMissingBodyIsRefusedWithTheLineThatNamesIt) {
  const std::string mine = put("mine.ini", kNamed + "[body]\nxml = own.xml\n");
  EXPECT_EQ(refusal([&] { readModel(mine); }), mine + ", line 4: [body] xml = own.xml: there is no file " +
                                                   (folder_ / "own.xml") +
                                                   "; give a file that lies beside the model file, or darwin-op.xml");
  fs::create_directory(folder_ / "own.xml");
  EXPECT_THAT(refusal([&] { readModel(mine); }), HasSubstr((folder_ / "own.xml") + " is a folder; "));
}

TEST_F(OwnModels, AFolderOrAMissingFileIsNoModel) {
  EXPECT_THAT(refusal([&] { readModel(folder_ / ""); }), HasSubstr(" is a folder; name a model file in it"));
  EXPECT_EQ(refusal([&] { readModel(folder_ / "no.ini"); }),
            "there is no model file " + (folder_ / "no.ini") + "; the shipped models are darwin-op and webots-2013");
}

}  // namespace
}  // namespace darwinop::twin
