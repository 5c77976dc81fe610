// A model file in another folder has the body of the one that it was written from.
#include "twin/model/copy_body.hpp"

#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>

#include "support/temporary_folder.hpp"
#include "support/text_of.hpp"
#include "twin/model/messages.hpp"
#include "twin/model/texts.hpp"

namespace darwinop::twin {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::IsEmpty;

class CopyBody : public testing::Test {
 protected:
  /// A model in own/ with a body file `xml`, which is not the shipped one.
  Model own(const std::string& xml) {
    write("own/" + xml, "<mujoco model=\"own\"/>");
    write("own/model.ini", std::string{kNamed} + "\n[body]\nxml = " + xml + "\n");
    return readModel(folder_ / "own/model.ini");
  }
  void write(const std::string& name, const std::string& text) {
    fs::create_directories(fs::path{folder_ / name}.parent_path());
    std::ofstream{folder_ / name} << text;
  }
  /// Text of the body that a copy of the model file in other/ has.
  std::string bodyThere() {
    fs::create_directories(folder_ / "other");
    fs::copy_file(folder_ / "own/model.ini", folder_ / "other/model.ini", fs::copy_options::overwrite_existing);
    const Model there = readModel(folder_ / "other/model.ini");
    return textOf((fs::path{there.folder} / there.body.xml).string());
  }

  TemporaryFolder folder_;
};

TEST_F(CopyBody, AnEditedBodyGoesAlongWhateverItsNameAndFolder) {
  for (const std::string xml : {"darwin-op.xml", "mine.xml", "bodies/mine.xml"}) {
    EXPECT_THAT(copyBody(own(xml), folder_ / "other", OtherBody::kKeep), IsEmpty()) << xml;
    EXPECT_THAT(bodyThere(), HasSubstr("own")) << xml;
  }
}

TEST_F(CopyBody, AShippedBodyIsFoundAnyway) {
  write("own/model.ini", kNamed);
  EXPECT_THAT(copyBody(readModel(folder_ / "own/model.ini"), folder_ / "other", OtherBody::kReplace), IsEmpty());
  EXPECT_FALSE(fs::exists(folder_ / "other/darwin-op.xml"));
}

TEST_F(CopyBody, AnotherBodyOfTheNameIsReplacedOrReported) {
  const Model model = own("darwin-op.xml");
  write("other/darwin-op.xml", "<mujoco model=\"another\"/>");
  EXPECT_THAT(copyBody(model, folder_ / "other", OtherBody::kKeep), HasSubstr(messages::kNotTheBody));
  EXPECT_THAT(bodyThere(), HasSubstr("another"));
  EXPECT_THAT(copyBody(model, folder_ / "other", OtherBody::kReplace), IsEmpty());
  EXPECT_THAT(bodyThere(), HasSubstr("own"));
}

TEST_F(CopyBody, NothingIsWrittenOutsideOfTheFolder) {
  write("own/model.ini", "");
  const Model model = own("../mine.xml");
  EXPECT_THAT(copyBody(model, folder_ / "deep/other", OtherBody::kReplace), HasSubstr(messages::kOutsideOfFolder));
  EXPECT_FALSE(fs::exists(folder_ / "deep/mine.xml"));
}

}  // namespace
}  // namespace darwinop::twin
