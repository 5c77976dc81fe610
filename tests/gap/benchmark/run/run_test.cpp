// A suite with trivial results: which cases it runs, what it writes, which errors it survives. Each test holds for one
// process and under mpirun, where all ranks execute it.
#include <gmock/gmock.h>
#include <sys/stat.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <set>

#include "gap/benchmark/run/answer.hpp"
#include "gap/benchmark/run/benchmark_folder.hpp"
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

std::string refusal(const Suite& suite) {
  try {
    (void)runSuite(suite);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

/// Under mpirun the folder is that of all ranks.
class SuiteRun : public testing::Test {
 protected:
  SuiteFolder folder{{"c", "a", "b"}};
  Suite suite = withAnswers();

  Suite withAnswers() {
    Suite one;
    one.folder = folder.cases();
    one.out = folder.results();
    one.answer = [](const std::string& path) { return cheapAnswer(path); };
    return one;
  }
  json written() const { return json::parse(std::ifstream{folder.results()}); }
};

TEST_F(SuiteRun, AnswersEveryCaseInTheOrderOfTheNames) {
  const json answers = runSuite(suite);
  if (!Ranks::isFirst()) return;
  EXPECT_THAT(namesOf(answers), ElementsAre("a", "b", "c"));
  EXPECT_EQ(written(), answers);
  EXPECT_EQ(answers[0].at("case_hash").get<std::string>().size(), 64U);
  EXPECT_EQ(errorsIn(answers), 0U);
}

TEST_F(SuiteRun, AcceptsTheFolderAroundTheCases) {
  suite.folder = folder.top();
  const json answers = runSuite(suite);
  EXPECT_EQ(answers.size(), Ranks::isFirst() ? 3U : 0U);
}

TEST_F(SuiteRun, ReportsEachCaseWhenItIsDone) {
  std::vector<std::size_t> done;
  std::set<std::string> names;
  suite.progress = [&](const SuiteProgress& progress) {
    done.push_back(progress.done);
    names.insert(progress.answer.at("case"));
    EXPECT_EQ(progress.of, 3U);
    EXPECT_EQ(written().size(), progress.done) << "results are written as they come";
  };
  (void)runSuite(suite);
  if (!Ranks::isFirst()) return;
  EXPECT_THAT(done, ElementsAre(1, 2, 3));
  EXPECT_EQ(names.size(), 3U);
}

class SuiteAlone : public SuiteRun {
 protected:
  void SetUp() override {
    if (Ranks::count() > 1) GTEST_SKIP() << "for one process";
  }
};

TEST_F(SuiteAlone, APipeInPlaceOfACaseIsNotWaitedFor) {
  const std::string file = folder.cases() + "/b/case.json";
  std::filesystem::remove(file);
  ASSERT_EQ(mkfifo(file.c_str(), 0600), 0);
  EXPECT_EQ(fingerprintOf(folder.cases() + "/b"), "");
}

TEST_F(SuiteAlone, ResumeAnswersOnlyWhatHasNoAnswer) {
  (void)runSuite(suite);
  folder.add("d");
  std::set<std::string> run;
  suite.answer = [&](const std::string& path) {
    run.insert(std::filesystem::path{path}.filename());
    return cheapAnswer(path);
  };
  suite.resume = true;
  std::size_t kept = 0;
  suite.begun = [&](std::size_t count) { kept = count; };
  EXPECT_THAT(namesOf(runSuite(suite)), ElementsAre("a", "b", "c", "d"));
  EXPECT_THAT(run, ElementsAre("d"));
  EXPECT_EQ(kept, 3U);
}

TEST_F(SuiteAlone, ResumeRunsAnotherCaseOfTheSameNameAgain) {
  (void)runSuite(suite);
  folder.change("b");
  folder.remove("c");
  suite.resume = true;
  std::set<std::string> run;
  suite.progress = [&](const SuiteProgress& progress) { run.insert(progress.answer.at("case")); };
  EXPECT_THAT(namesOf(runSuite(suite)), ElementsAre("a", "b"));
  EXPECT_THAT(run, ElementsAre("b"));
}

TEST_F(SuiteAlone, ResumeRunsACaseWithOtherLogsAgain) {
  std::ofstream{folder.cases() + "/b/case.json"} << R"({"logs": [{"file": "fit_1.csv"}]})";
  std::ofstream{folder.cases() + "/b/fit_1.csv"} << "time\n0\n";
  (void)runSuite(suite);
  std::ofstream{folder.cases() + "/b/fit_1.csv"} << "time\n1\n";
  suite.resume = true;
  std::set<std::string> run;
  suite.progress = [&](const SuiteProgress& progress) { run.insert(progress.answer.at("case")); };
  EXPECT_EQ(runSuite(suite).size(), 3U);
  EXPECT_THAT(run, ElementsAre("b"));
}

TEST_F(SuiteAlone, AKilledRunLosesOnlyTheCaseInProgress) {
  suite.answer = [&](const std::string& path) -> json {
    if (path.ends_with("b")) throw 1;  // nothing that is caught: as good as a kill
    return cheapAnswer(path);
  };
  EXPECT_ANY_THROW((void)runSuite(suite));
  suite = withAnswers();
  suite.resume = true;
  std::set<std::string> run;
  suite.progress = [&](const SuiteProgress& progress) { run.insert(progress.answer.at("case")); };
  EXPECT_EQ(runSuite(suite).size(), 3U);
  EXPECT_THAT(run, ElementsAre("b", "c"));
}

TEST_F(SuiteAlone, WithoutResumeItStartsAgainAndKeepsTheOldFile) {
  (void)runSuite(suite);
  folder.remove("c");
  EXPECT_EQ(runSuite(suite).size(), 2U);
  EXPECT_EQ(json::parse(std::ifstream{folder.results() + ".before"}).size(), 3U);
}

TEST_F(SuiteAlone, SeveralCasesAtOnceGiveTheSame) {
  const json one = runSuite(suite);
  suite.jobs = 3;
  EXPECT_EQ(runSuite(suite), one);
}

TEST_F(SuiteAlone, AnErrorIsCountedAndTriedAgain) {
  suite.answer = [](const std::string& path) {
    json answer = cheapAnswer(path);
    if (path.ends_with("b")) answer["verdict"] = "error";
    return answer;
  };
  EXPECT_EQ(errorsIn(runSuite(suite)), 1U);
  suite = withAnswers();
  suite.resume = true;
  std::set<std::string> run;
  suite.progress = [&](const SuiteProgress& progress) { run.insert(progress.answer.at("case")); };
  EXPECT_EQ(errorsIn(runSuite(suite)), 0U);
  EXPECT_THAT(run, ElementsAre("b"));
}

TEST_F(SuiteAlone, RefusalsNameARemedy) {
  suite.folder = folder.cases() + "/a";
  EXPECT_THAT(refusal(suite), HasSubstr("/a: is a single case; use `darwinop gap run`"));
  suite.folder = folder.cases() + "/nowhere";
  EXPECT_THAT(refusal(suite), HasSubstr("not a folder"));
  suite = withAnswers();
  suite.out = folder.cases() + "/nowhere/results.json";
  EXPECT_THAT(refusal(suite), HasSubstr(suite.out + ": " + std::strerror(ENOENT)));
  suite = withAnswers();
  std::ofstream{suite.out} << "no json";
  suite.resume = true;
  EXPECT_THAT(refusal(suite), HasSubstr("results.json: not a results.json of benchmark run"));
}

TEST_F(SuiteAlone, BytesOfABrokenFileDoNotBreakTheResults) {
  suite.answer = [](const std::string& path) {
    json answer = cheapAnswer(path);
    answer["why"] = "column \xff is unknown";
    return answer;
  };
  EXPECT_EQ(runSuite(suite).size(), 3U);
  EXPECT_THAT(written()[0].at("why").get<std::string>(), HasSubstr("is unknown"));  // no message
}

}  // namespace
}  // namespace darwinop::gap
