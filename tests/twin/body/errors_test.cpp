// Invalid bodies: error messages.
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "hal/text_file.hpp"
#include "support/text_of.hpp"
#include "twin/body/mujoco_guard.hpp"
#include "twin/body/support.hpp"

namespace darwinop::twin::test {
namespace {

class RefusedBody : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = std::filesystem::path{testing::TempDir()} / ("twin_body_refused_" + std::to_string(getpid()));
    std::filesystem::create_directories(folder_);
    xml_ = textOf(std::string{DARWINOP_MODELS} + "/darwin-op.xml");
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

TEST_F(RefusedBody, NamesAMissingFile) {
  const std::string why = refusalOf("missing.xml");
  EXPECT_NE(why.find("missing.xml"), std::string::npos) << why;
  EXPECT_NE(why.find("[body]"), std::string::npos) << why;
}

TEST_F(RefusedBody, DoesNotWaitForTheWriterOfAPipe) {
  ASSERT_EQ(mkfifo((folder_ / "pipe.xml").c_str(), 0600), 0);
  EXPECT_NE(refusalOf("pipe.xml").find(kPipeInsteadOfFile), std::string::npos);
}

TEST_F(RefusedBody, ReportsMujocosMessageAboutBrokenXml) {
  xml_.resize(xml_.size() / 2);
  const std::string why = refusal();
  EXPECT_NE(why.find("darwin-op.xml: MuJoCo cannot load this body: "), std::string::npos) << why;
}

TEST_F(RefusedBody, IsAnEmptyFile) {
  xml_.clear();
  EXPECT_NE(refusal().find("darwin-op.xml: the body file is empty"), std::string::npos);
}

TEST_F(RefusedBody, IsReportedInOneLine) {
  xml_.resize(xml_.size() / 2);
  EXPECT_EQ(refusal().find('\n'), std::string::npos);
}

// MuJoCo's default handler of this error waits for Enter and ends the program.
TEST_F(RefusedBody, IsOneThatRaisesAMujocoError) {
  replaceAll("<size njmax=\"600\"", "<size nstack=\"2000\" njmax=\"600\"");
  const std::string why = refusal();
  EXPECT_NE(why.find(kMujocoError), std::string::npos) << why;
  EXPECT_NE(why.find("tack"), std::string::npos) << why;  // stack overflow
}

TEST_F(RefusedBody, IsOneWithABufferTooSmallForItsContacts) {
  replaceAll("<size njmax=\"600\"", "<size njmax=\"20\"");
  const std::string why = refusal();
  EXPECT_NE(why.find("darwin-op.xml: the simulation stopped"), std::string::npos) << why;
}

TEST_F(RefusedBody, NeedsASupportedIntegrator) {
  replaceAll("integrator=\"Euler\"", "integrator=\"RK4\"");
  EXPECT_NE(refusal().find("use Euler"), std::string::npos);
}

TEST(UnstableSimulation, StopsAndReportsTheReason) {
  RobotBody body{modelWith(0.025)};
  run(body, limp(), 0.1);
  ASSERT_EQ(body.error(), nullptr);
  trunkQvel(body)[0] = std::numeric_limits<double>::infinity();
  run(body, limp(), 0.1);
  ASSERT_NE(body.error(), nullptr);
  const std::string why = body.error();
  EXPECT_NE(why.find("the simulation stopped at 0.1"), std::string::npos) << why;
  EXPECT_NE(why.find("reduce [body] step"), std::string::npos) << why;
  for (const JointMotion& joint : body.state().joint) EXPECT_TRUE(std::isfinite(joint.position_rad));
  for (const double axis : body.state().gyro_rad_s) EXPECT_TRUE(std::isfinite(axis));
}

TEST_F(RefusedBody, NamesAMissingJoint) {
  replaceAll("<joint name=\"Neck\"", "<joint name=\"Nock\"");
  replaceAll("joint=\"Neck\"", "joint=\"Nock\"");
  const std::string why = refusal();
  EXPECT_NE(why.find("the body has no joint \"Neck\""), std::string::npos) << why;
}

TEST_F(RefusedBody, NamesAMissingSensor) {
  replaceAll("site name=\"gyro\"", "site name=\"spin\"");
  EXPECT_NE(refusal().find("the body has no site \"gyro\""), std::string::npos);
}

TEST_F(RefusedBody, IsOneWithoutAFreeJoint) {
  replaceAll("<freejoint name=\"Body\"/>", "");  // no message
  EXPECT_NE(refusal().find("<freejoint/>"), std::string::npos);
}

}  // namespace
}  // namespace darwinop::twin::test
