// Goals that were written a declared time before their row was read.
#include "gap/case/write_time.hpp"

#include <gmock/gmock.h>

#include "gap/case/bam_log.hpp"
#include "gap/case/messages.hpp"
#include "gap/case/raw_folder_rig.hpp"
#include "gap/case/write_case.hpp"

namespace darwinop::gap {
namespace {

using testing::Each;
using testing::HasSubstr;

struct WriteTime : RawFolderTest {
  WriteTime() { addLog("a", 32, "0.5"), addLog("b", 64, "0.5"); }
  [[nodiscard]] FolderCase readDeclaring(const std::vector<std::string>& declared) const {
    return readRawFolder(
        {.folder = folder / "", .model = out / "model.ini", .declared = declared, .held_out = {}, .all_logs = true});
  }
  [[nodiscard]] std::string refusalOf(const std::vector<std::string>& declared) const {
    try {
      (void)readDeclaring(declared);
    } catch (const BadInput& error) {
      return error.what();
    }
    return "";
  }
};

TEST_F(WriteTime, OfBamsLogsIsInTheCase) {
  const FolderCase read = readDeclaring({"written_before_s=0.0025"});
  writeCase(read.given, out / "case");
  const Case back = readCase(out / "case");
  ASSERT_TRUE(back.logs[0].isReadAfterWrite());
  EXPECT_THAT(back.logs[0].written_s, Each(0));
  EXPECT_THAT(back.logs[0].read_s, Each(0.0025));
  for (const Case& one : {read.given, back}) EXPECT_FALSE(one.logs[0].is_phase_known) << "the firmware runs on its own";
  EXPECT_EQ(back.logs[0].goal_rad, readDeclaring({}).given.logs[0].goal_rad);
}

TEST_F(WriteTime, IsNotInBamsFormatWhichHasEachGoalInItsRow) {
  const FolderCase read = readDeclaring({"written_before_s=0.0025"});
  const BamLog back = parseBamLog(asBamJson(read.given, read.given.logs[0], "mx28"), "a.json", "a");
  EXPECT_EQ(back.log.goal_rad, read.given.logs[0].goal_rad);
}

TEST_F(WriteTime, IsLessThanARowAndOfGoalsBeforeTheRead) {
  EXPECT_THAT(refusalOf({"written_before_s=2.5"}), HasSubstr("rows are 12.5 ms apart"));
  EXPECT_THAT(refusalOf({"written_before_s=0"}), HasSubstr("rows are 12.5 ms apart"));
  EXPECT_THAT(refusalOf({"written_before_s=0.002", "goal_order=after_read"}), HasSubstr(messages::kOfBeforeRead));
}

}  // namespace
}  // namespace darwinop::gap
