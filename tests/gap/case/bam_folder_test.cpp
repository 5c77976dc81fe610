// A folder of BAM logs as a case, and which of them are held out.
#include <gmock/gmock.h>

#include <algorithm>
#include <fstream>

#include "gap/case/bam_text.hpp"
#include "gap/case/case_texts.hpp"
#include "gap/case/folder_files.hpp"
#include "gap/case/messages.hpp"
#include "gap/case/write_case.hpp"
#include "support/replaced.hpp"
#include "support/temporary_folder.hpp"

namespace darwinop::gap {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

void write(const std::string& path, const std::string& text) {
  std::ofstream{path} << text;
}

FolderCase readFolder(const std::string& folder, const std::string& model,
                      const std::vector<std::string>& held_out = {}) {
  return readRawFolder({.folder = folder, .model = model, .declared = {}, .held_out = held_out});
}

TEST(BamFolder, AFolderBecomesACaseOfSeveralArms) {
  const TemporaryFolder folder, out;
  const std::string model = out / "model.ini";
  write(model, "[model]\nname = any\n");
  write(folder / "a.json", bamText(zero, zero));
  write(folder / "b.json", replaced(bamText(zero, zero), "\"length\": 0.15", "\"length\": 0.1"));
  write(folder / "c.json", bamText(zero, zero));
  write(folder / "d.json", replaced(bamText(zero, zero), "\"kp\": 32", "\"kp\": 64"));
  const FolderCase read = readFolder(folder / "", model);
  ASSERT_EQ(read.given.logs.size(), 4u);
  EXPECT_FALSE(read.given.logs[0].held_out);
  EXPECT_TRUE(read.given.logs[3].held_out) << "another gain shows whether the model generalizes";
  writeCase(read.given, out / "case");
  const Case back = readCase(out / "case");
  EXPECT_EQ(armOf(back, back.logs[0]).length_m, 0.15);
  EXPECT_EQ(armOf(back, back.logs[1]).length_m, 0.1);
  EXPECT_EQ(back.logs[1].current_a[5], 0.5);
  EXPECT_EQ(back.goal_order, GoalOrder::kBeforeRead);
  EXPECT_FALSE(back.logs[0].is_session_known) << "a log of BAM has a clock of its own";
  EXPECT_TRUE(readFolder(folder / "", model, {"b.json"}).given.logs[1].held_out);
  try {
    (void)readFolder(folder / "", model, {"a", "b", "c", "d"});
    ADD_FAILURE();
  } catch (const BadInput& refused) {
    EXPECT_THAT(refused.what(), HasSubstr(messages::kKeepsAll));
  }
}

TEST(BamFolder, OfOneGainTheLastQuarterIsHeldOut) {
  const TemporaryFolder folder, out;
  const std::string model = out / "model.ini";
  write(model, "[model]\nname = any\n");
  std::vector<long> held;
  for (const char* const name : {"a.json", "b.json", "c.json", "d.json", "e.json"}) {
    write(folder / name, bamText(zero, zero));
    const FolderCase read = readFolder(folder / "", model);
    held.push_back(std::ranges::count_if(read.given.logs, &Trajectory::held_out));
  }
  EXPECT_THAT(held, ElementsAre(0, 1, 0, 1, 2)) << "three are fitted where there are three, and a lone one";
}

TEST(BamFolder, AGainWithoutWhichTwoLogsRemainIsNotHeldOut) {
  const TemporaryFolder folder, out;
  const std::string model = out / "model.ini";
  write(model, "[model]\nname = any\n");
  for (const char* const name : {"a.json", "b.json"}) write(folder / name, bamText(zero, zero));
  for (const char* const name : {"c.json", "d.json"})
    write(folder / name, replaced(bamText(zero, zero), "\"kp\": 32", "\"kp\": 64"));
  const FolderCase read = readFolder(folder / "", model);
  EXPECT_EQ(std::ranges::count_if(read.given.logs, &Trajectory::held_out), 1);
}

TEST(BamFolder, AGainOfMostLogsIsNotHeldOut) {
  const TemporaryFolder folder, out;
  const std::string model = out / "model.ini";
  write(model, "[model]\nname = any\n");
  for (const char* const name : {"b.json", "c.json", "d.json"}) write(folder / name, bamText(zero, zero));
  write(folder / "a.json", replaced(bamText(zero, zero), "\"kp\": 32", "\"kp\": 16"));
  const FolderCase read = readFolder(folder / "", model);
  EXPECT_EQ(std::ranges::count_if(read.given.logs, &Trajectory::held_out), 1);
  EXPECT_TRUE(read.given.logs[3].held_out);
}

TEST(BamFolder, AHeldOutLogThatIsNotThereIsRefused) {
  const TemporaryFolder folder, out;
  const std::string model = out / "model.ini";
  write(model, "[model]\nname = any\n");
  write(folder / "a.json", bamText(zero, zero));
  write(folder / "b.json", bamText(zero, zero));
  try {
    (void)readFolder(folder / "", model, {"a.json", "chirp.json"});
    ADD_FAILURE();
  } catch (const BadInput& refused) {
    EXPECT_THAT(refused.what(), HasSubstr("chirp.json" + std::string{messages::kNotLogOfFolder}));
  }
}

}  // namespace
}  // namespace darwinop::gap
