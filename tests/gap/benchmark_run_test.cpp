// A battery with answers that cost nothing: which cases it runs, what it writes, what it survives. Each test holds for
// one process and under mpirun, where all ranks come to it.
#include <gmock/gmock.h>
#include <sys/stat.h>

#include <fstream>
#include <set>

#include "benchmark_folder.hpp"
#include "gap/benchmark/run/answer.hpp"
#include "gap/benchmark/run/results.hpp"
#include "gap/benchmark/run/suite.hpp"
#include "gap/parallel/ranks.hpp"

namespace darwinop::gap {
namespace {

using nlohmann::json;
using testing::ElementsAre;
using testing::HasSubstr;

std::vector<std::string> namesOf(const json& answers) {
  std::vector<std::string> names;
  for (const json& answer : answers) names.push_back(answer.at("case"));
  return names;
}

std::string refusal(const Suite& battery) {
  try {
    (void)runSuite(battery);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

/// Under mpirun the folder is that of all ranks.
class BatteryRun : public testing::Test {
 protected:
  BatteryFolder folder{{"c", "a", "b"}};
  Suite battery = withAnswers();

  Suite withAnswers() {
    Suite one;
    one.folder = folder.cases();
    one.out = folder.results();
    one.answer = [](const std::string& path) { return cheapAnswer(path); };
    return one;
  }
  json written() const { return json::parse(std::ifstream{folder.results()}); }
};

TEST_F(BatteryRun, AnswersEveryCaseInTheOrderOfTheNames) {
  const json answers = runSuite(battery);
  if (!Ranks::isFirst()) return;
  EXPECT_THAT(namesOf(answers), ElementsAre("a", "b", "c"));
  EXPECT_EQ(written(), answers);
  EXPECT_EQ(answers[0].at("case_hash").get<std::string>().size(), 64U);
  EXPECT_EQ(errorsIn(answers), 0U);
}

TEST_F(BatteryRun, TakesTheFolderAroundTheCasesToo) {
  battery.folder = folder.top();
  const json answers = runSuite(battery);
  EXPECT_EQ(answers.size(), Ranks::isFirst() ? 3U : 0U);
}

TEST_F(BatteryRun, TellsEachCaseAsItIsDone) {
  std::vector<std::size_t> done;
  std::set<std::string> names;
  battery.progress = [&](const SuiteProgress& progress) {
    done.push_back(progress.done);
    names.insert(progress.answer.at("case"));
    EXPECT_EQ(progress.of, 3U);
    EXPECT_EQ(written().size(), progress.done) << "results are written as they come";
  };
  (void)runSuite(battery);
  if (!Ranks::isFirst()) return;
  EXPECT_THAT(done, ElementsAre(1, 2, 3));
  EXPECT_EQ(names.size(), 3U);
}

class BatteryAlone : public BatteryRun {
 protected:
  void SetUp() override {
    if (Ranks::count() > 1) GTEST_SKIP() << "for one process";
  }
};

TEST_F(BatteryAlone, APipeInPlaceOfACaseIsNotWaitedFor) {
  const std::string file = folder.cases() + "/b/case.json";
  std::filesystem::remove(file);
  ASSERT_EQ(mkfifo(file.c_str(), 0600), 0);
  EXPECT_EQ(fingerprintOf(folder.cases() + "/b"), "");
}

TEST_F(BatteryAlone, ResumeAnswersOnlyWhatHasNoAnswer) {
  (void)runSuite(battery);
  folder.add("d");
  std::set<std::string> run;
  battery.answer = [&](const std::string& path) {
    run.insert(std::filesystem::path{path}.filename());
    return cheapAnswer(path);
  };
  battery.resume = true;
  std::size_t kept = 0;
  battery.begun = [&](std::size_t count) { kept = count; };
  EXPECT_THAT(namesOf(runSuite(battery)), ElementsAre("a", "b", "c", "d"));
  EXPECT_THAT(run, ElementsAre("d"));
  EXPECT_EQ(kept, 3U);
}

TEST_F(BatteryAlone, ResumeRunsAnotherCaseOfTheSameNameAnew) {
  (void)runSuite(battery);
  folder.change("b");
  folder.remove("c");
  battery.resume = true;
  std::set<std::string> run;
  battery.progress = [&](const SuiteProgress& progress) { run.insert(progress.answer.at("case")); };
  EXPECT_THAT(namesOf(runSuite(battery)), ElementsAre("a", "b"));
  EXPECT_THAT(run, ElementsAre("b"));
}

TEST_F(BatteryAlone, AKilledRunLosesNoMoreThanTheCaseItWasAt) {
  battery.answer = [&](const std::string& path) -> json {
    if (path.ends_with("b")) throw 1;  // nothing that is caught: as good as a kill
    return cheapAnswer(path);
  };
  EXPECT_ANY_THROW((void)runSuite(battery));
  battery = withAnswers();
  battery.resume = true;
  std::set<std::string> run;
  battery.progress = [&](const SuiteProgress& progress) { run.insert(progress.answer.at("case")); };
  EXPECT_EQ(runSuite(battery).size(), 3U);
  EXPECT_THAT(run, ElementsAre("b", "c"));
}

TEST_F(BatteryAlone, WithoutResumeItBeginsAnewAndKeepsTheOldFile) {
  (void)runSuite(battery);
  folder.remove("c");
  EXPECT_EQ(runSuite(battery).size(), 2U);
  EXPECT_EQ(json::parse(std::ifstream{folder.results() + ".before"}).size(), 3U);
}

TEST_F(BatteryAlone, SeveralCasesAtOnceGiveTheSame) {
  const json one = runSuite(battery);
  battery.jobs = 3;
  EXPECT_EQ(runSuite(battery), one);
}

TEST_F(BatteryAlone, AnErrorIsCountedAndTriedAgain) {
  battery.answer = [](const std::string& path) {
    json answer = cheapAnswer(path);
    if (path.ends_with("b")) answer["verdict"] = "error";
    return answer;
  };
  EXPECT_EQ(errorsIn(runSuite(battery)), 1U);
  battery = withAnswers();
  battery.resume = true;
  std::set<std::string> run;
  battery.progress = [&](const SuiteProgress& progress) { run.insert(progress.answer.at("case")); };
  EXPECT_EQ(errorsIn(runSuite(battery)), 0U);
  EXPECT_THAT(run, ElementsAre("b"));
}

TEST_F(BatteryAlone, RefusalsSayWhatToDo) {
  battery.folder = folder.cases() + "/a";
  EXPECT_THAT(refusal(battery), HasSubstr("/a: is a single case; use `darwinop gap run`"));
  battery.folder = folder.cases() + "/nowhere";
  EXPECT_THAT(refusal(battery), HasSubstr("not a folder"));
  battery = withAnswers();
  battery.out = folder.cases() + "/nowhere/results.json";
  EXPECT_THAT(refusal(battery), HasSubstr("cannot write"));
  battery = withAnswers();
  std::ofstream{battery.out} << "no json";
  battery.resume = true;
  EXPECT_THAT(refusal(battery), HasSubstr("results.json: not a results.json of benchmark run"));
}

TEST_F(BatteryAlone, BytesOfABrokenFileDoNotBreakTheResults) {
  battery.answer = [](const std::string& path) {
    json answer = cheapAnswer(path);
    answer["why"] = "column \xff is unknown";
    return answer;
  };
  EXPECT_EQ(runSuite(battery).size(), 3U);
  EXPECT_THAT(written()[0].at("why").get<std::string>(), HasSubstr("is unknown"));
}

}  // namespace
}  // namespace darwinop::gap
