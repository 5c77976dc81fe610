// A suite opens case.json and the logs that it names, and nothing else, as inotify reports.
#include <gmock/gmock.h>
#include <sys/inotify.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cstring>
#include <map>
#include <set>

#include "core/units.hpp"
#include "gap/benchmark/run/benchmark_folder.hpp"
#include "gap/benchmark/run/suite.hpp"
#include "gap/case/write_case.hpp"
#include "gap/small_case.hpp"

namespace darwinop::gap {
namespace {

using testing::AllOf;
using testing::EndsWith;
using testing::HasSubstr;
using testing::StartsWith;
using testing::UnorderedElementsAre;

/// Names of the files in some folders that were opened since it began to look.
class OpenedFiles {
 public:
  explicit OpenedFiles(const std::vector<std::string>& folders) {
    for (const std::string& folder : folders)
      if (inotify_add_watch(watch_, folder.c_str(), IN_OPEN) < 0) broken_ = true;
  }
  ~OpenedFiles() { close(watch_); }
  OpenedFiles(const OpenedFiles&) = delete;
  OpenedFiles& operator=(const OpenedFiles&) = delete;

  [[nodiscard]] bool isBroken() const { return broken_ || watch_ < 0; }
  std::set<std::string> names() const {
    std::set<std::string> names;
    alignas(inotify_event) std::array<char, 4096> bytes{};
    for (ssize_t size = 0; (size = read(watch_, bytes.data(), bytes.size())) > 0;)
      for (ssize_t at = 0; at < size;) {
        inotify_event event{};
        std::memcpy(&event, bytes.data() + at, sizeof event);
        if ((event.mask & IN_ISDIR) == 0 && event.len > 0) names.insert(bytes.data() + at + sizeof event);
        at += static_cast<ssize_t>(sizeof event + event.len);
      }
    return names;
  }

 private:
  int watch_ = inotify_init1(IN_NONBLOCK);
  bool broken_ = false;
};

/// Commands of the small bench, and a joint that follows them: enough to be read.
Case tame() {
  Case bench = smallBench();
  bench.model.name = bench.name;
  return measured(bench, baselineOf(bench), 3);
}

void addKey(const std::string& folder) {
  std::filesystem::create_directories(folder);
  const std::string path = folder + "/key.json";
  std::ofstream{path} << R"({"a": {"cls": "single", "effects": [{"id": "coulomb"}]})" << '\0' << "poison";
  chmod(path.c_str(), 0);  // root may read it all the same
}

TEST(SuiteIsBlind, OnlyTheCaseAndItsLogsAreOpened) {
  const SuiteFolder folder{{}};
  const std::string one = folder.cases() + "/a";
  writeCase(tame(), one);
  for (const std::string& beside : {folder.top(), folder.cases(), one}) addKey(beside);
  std::ofstream{one + "/fit_9.csv"} << "a log that no case names";

  Suite suite;
  suite.folder = folder.top();
  // All of the reading, without the hours of thought behind it.
  suite.answer = [](const std::string& path) {
    nlohmann::json answer = cheapAnswer(path);
    answer["logs"] = readCase(path).logs.size();
    return answer;
  };
  const OpenedFiles opened{{folder.top(), folder.cases(), one}};
  if (opened.isBroken()) GTEST_SKIP() << "inotify reports nothing on this machine";
  EXPECT_EQ(runSuite(suite)[0].at("logs"), 4);
  EXPECT_THAT(opened.names(),
              UnorderedElementsAre("case.json", "steps.csv", "triangle.csv", "release.csv", "kept.csv"));
}

TEST(SuiteIsBlind, TheTestDetectsAnOpenedKey) {
  const SuiteFolder folder{{"a"}};
  addKey(folder.cases());
  const OpenedFiles opened{{folder.cases()}};
  if (opened.isBroken()) GTEST_SKIP() << "inotify reports nothing on this machine";
  chmod((folder.cases() + "/key.json").c_str(), 0600);
  std::ifstream{folder.cases() + "/key.json"}.peek();
  EXPECT_THAT(opened.names(), UnorderedElementsAre("key.json"));
}

TEST(Answer, ACaseThatCannotBeUsedHasAReason) {
  const SuiteFolder folder{{"empty"}};
  const nlohmann::json answer = answerFor(folder.cases() + "/empty");
  EXPECT_EQ(answer.at("case"), "empty");
  EXPECT_EQ(answer.at("verdict"), "bad_input");
  EXPECT_THAT(answer.at("why").get<std::string>(), HasSubstr("case.json"));
  EXPECT_THAT(lineOf(answer), testing::StartsWith("empty  bad_input: case.json: "));
}

TEST(Answer, DegreesInPlaceOfRadiansAreBadInput) {
  Case given = tame();
  for (Trajectory& log : given.logs)
    for (auto* const column : {&log.goal_rad, &log.position_rad})
      for (double& angle : *column) angle *= 180 / kPi;
  const SuiteFolder folder{{}};
  writeCase(given, folder.cases() + "/a");
  const nlohmann::json answer = answerFor(folder.cases() + "/a");
  EXPECT_EQ(answer.at("verdict"), "bad_input") << answer.dump(1);
  EXPECT_THAT(answer.at("why").get<std::string>(), HasSubstr("_deg"));
  // One column alone as well.
  for (Trajectory& log : given.logs)
    for (double& angle : log.goal_rad) angle *= kPi / 180;
  writeCase(given, folder.cases() + "/b");
  EXPECT_EQ(answerFor(folder.cases() + "/b").at("verdict"), "bad_input");
}

TEST(Answer, ALineHasTheFinding) {
  const nlohmann::json named = {{"case", "e07"},
                                {"verdict", "named"},
                                {"effects", {{{"id", "coulomb"}}, {{"id", "backlash"}}}},
                                {"ambiguity", nlohmann::json::array()},
                                {"gap_score_before_mrad", 31},
                                {"gap_score_after_mrad", 0.9},
                                {"runtime_s", 12.3}};
  EXPECT_THAT(lineOf(named), AllOf(StartsWith("e07  named "), HasSubstr(" coulomb + backlash "),
                                   HasSubstr(" 31.00 -> 0.90 mrad "), EndsWith(" 12.3 s")));
  nlohmann::json set = named;
  set["verdict"] = "ambiguous";
  set["ambiguity"].push_back(nlohmann::json::array({"coulomb", "deadband"}));
  set["gap_score_after_mrad"] = nullptr;
  EXPECT_EQ(lineOf(set), "e07  ambiguous: coulomb or deadband  12.3 s");
}

}  // namespace
}  // namespace darwinop::gap
