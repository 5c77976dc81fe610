// Bodies that are refused, each with a sentence that says why.
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "twin/body/support.hpp"

namespace darwinop::twin::test {
namespace {

class RefusedBody : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = std::filesystem::path{testing::TempDir()} / ("twin_body_refused_" + std::to_string(getpid()));
    std::filesystem::create_directories(folder_);
    std::ifstream file{std::string{DARWINOP_MODELS} + "/darwin-op.xml"};
    xml_ = {std::istreambuf_iterator<char>{file}, {}};
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  void replaceAll(const std::string& what, const std::string& with) {
    for (auto at = xml_.find(what); at != std::string::npos; at = xml_.find(what, at + with.size()))
      xml_.replace(at, what.size(), with);
  }
  [[nodiscard]] std::string refusal() const {
    std::ofstream{folder_ / "darwin-op.xml"} << xml_;
    return refusalOf("darwin-op.xml");
  }
  [[nodiscard]] std::string refusalOf(const std::string& name) const {
    Model model = modelWith();
    model.folder = folder_.string();
    model.body.xml = name;
    try {
      const RobotBody body{model};
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "";
  }
  std::filesystem::path folder_;
  std::string xml_;
};

TEST_F(RefusedBody, IsNoneAtAllWithTheShippedFile) {
  EXPECT_EQ(refusal(), "");
}

TEST_F(RefusedBody, NamesAFileThatIsNotThere) {
  const std::string why = refusalOf("nobody.xml");
  EXPECT_NE(why.find("nobody.xml: the body file cannot be read"), std::string::npos) << why;
  EXPECT_NE(why.find("section [body]"), std::string::npos) << why;
}

TEST_F(RefusedBody, DoesNotWaitForTheWriterOfAPipe) {
  ASSERT_EQ(mkfifo((folder_ / "pipe.xml").c_str(), 0600), 0);
  EXPECT_NE(refusalOf("pipe.xml").find("it is a pipe"), std::string::npos);
}

TEST_F(RefusedBody, TellsWhatMujocoSaysAboutBrokenXml) {
  xml_.resize(xml_.size() / 2);
  const std::string why = refusal();
  EXPECT_NE(why.find("darwin-op.xml: MuJoCo refuses this body: "), std::string::npos) << why;
}

TEST_F(RefusedBody, IsAnEmptyFile) {
  xml_.clear();
  EXPECT_NE(refusal().find("darwin-op.xml: the body file is empty"), std::string::npos);
}

TEST_F(RefusedBody, IsOneLineWhateverMujocoSays) {
  xml_.resize(xml_.size() / 2);
  EXPECT_EQ(refusal().find('\n'), std::string::npos);
}

// MuJoCo's own answer to this is to ask the terminal for Enter and to end the program.
TEST_F(RefusedBody, IsOneThatMujocoGivesUpOn) {
  replaceAll("<size njmax=\"600\"", "<size nstack=\"2000\" njmax=\"600\"");
  const std::string why = refusal();
  EXPECT_NE(why.find("MuJoCo gives up on this body"), std::string::npos) << why;
  EXPECT_NE(why.find("tack"), std::string::npos) << why;  // stack overflow
}

TEST_F(RefusedBody, IsOneWithoutRoomForItsContacts) {
  replaceAll("<size njmax=\"600\"", "<size njmax=\"20\"");
  const std::string why = refusal();
  EXPECT_NE(why.find("darwin-op.xml: the physics came to an end"), std::string::npos) << why;
}

TEST_F(RefusedBody, NeedsAnIntegratorThatWorksHere) {
  replaceAll("integrator=\"Euler\"", "integrator=\"RK4\"");
  EXPECT_NE(refusal().find("take Euler"), std::string::npos);
}

TEST(BrokenPhysics, StandsStillAndSaysSo) {
  RobotBody body{modelWith(0.025)};
  run(body, limp(), 0.1);
  ASSERT_EQ(body.trouble(), nullptr);
  trunkQvel(body)[0] = std::numeric_limits<double>::infinity();
  run(body, limp(), 0.1);
  ASSERT_NE(body.trouble(), nullptr);
  const std::string why = body.trouble();
  EXPECT_NE(why.find("the physics came to an end after 0.1"), std::string::npos) << why;
  EXPECT_NE(why.find("shorter [body] step"), std::string::npos) << why;
  for (const JointMotion& joint : body.state().joint) EXPECT_TRUE(std::isfinite(joint.position_rad));
  for (const double axis : body.state().gyro_rad_s) EXPECT_TRUE(std::isfinite(axis));
}

TEST_F(RefusedBody, NamesTheJointThatIsMissing) {
  replaceAll("<joint name=\"Neck\"", "<joint name=\"Nock\"");
  replaceAll("joint=\"Neck\"", "joint=\"Nock\"");
  const std::string why = refusal();
  EXPECT_NE(why.find("the body has no joint \"Neck\""), std::string::npos) << why;
}

TEST_F(RefusedBody, NamesTheSensorThatIsMissing) {
  replaceAll("site name=\"gyro\"", "site name=\"spin\"");
  EXPECT_NE(refusal().find("the body has no site \"gyro\""), std::string::npos);
}

TEST_F(RefusedBody, IsOneThatCannotFall) {
  replaceAll("<freejoint name=\"Body\"/>", "");
  EXPECT_NE(refusal().find("<freejoint/>"), std::string::npos);
}

}  // namespace
}  // namespace darwinop::twin::test
