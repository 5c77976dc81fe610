// Scores, against figures made by hand.
#include "gap/benchmark/score/score.hpp"

#include <gmock/gmock.h>
#include <sys/stat.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <nlohmann/json.hpp>

#include "gap/benchmark/score/parameter_names.hpp"
#include "hal/text_file.hpp"
#include "support/shared_data.hpp"
#include "support/temporary_folder.hpp"

namespace darwinop::gap {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

Key keyWith(CaseClass kind, std::vector<KeyEffect> effects, bool exact = true) {
  Key key;
  key.kind = kind;
  key.effects = std::move(effects);
  key.exact = exact;
  key.noise_held_out_rad = 0.001;
  return key;
}

CaseAnswer answerWith(const std::string& verdict, std::vector<AnswerEffect> effects = {}) {
  CaseAnswer answer;
  answer.verdict = verdict;
  answer.effects = std::move(effects);
  answer.before_rad = 0.02;
  answer.after_rad = 0.002;
  answer.runtime_s = 10;
  return answer;
}

const ShareFigure& share(const Score& score, const std::string& name) {
  for (const ShareFigure& figure : score.shares)
    if (figure.what == name) return figure;
  throw std::logic_error("no figure " + name);
}

const SpreadFigure& spread(const Score& score, const std::string& name) {
  for (const SpreadFigure& figure : score.spreads)
    if (figure.what == name) return figure;
  throw std::logic_error("no figure " + name);
}

void expectShare(const ShareFigure& figure, std::size_t right, std::size_t of) {
  EXPECT_EQ(figure.right, right) << figure.what;
  EXPECT_EQ(figure.of, of) << figure.what;
}

/// A case of each class, answered well and badly.
struct HandMade {
  Keys keys{
      {"a", keyWith(CaseClass::kSingle, {{"coulomb", 2, {{"Fc", 0.1}}}})},
      {"b", keyWith(CaseClass::kSingle, {{"backlash", 3, {{"play", 0.02}}}})},
      {"c", keyWith(CaseClass::kSingle, {{"deadband", 2, {{"width", 0.01}}}}, false)},
      {"d", keyWith(CaseClass::kSingle, {{"stribeck", 1, {{"Fs", 0.05}}}})},
      {"e", keyWith(CaseClass::kEffectFree, {})},
      {"f", keyWith(CaseClass::kEffectFree, {}, false)},
      {"g", keyWith(CaseClass::kDouble, {{"cogging", 2, {}}, {"coulomb", 2, {}}})},
      {"h", keyWith(CaseClass::kDouble, {{"viscous", 2, {}}, {"deadband", 2, {}}})},
      {"i", keyWith(CaseClass::kOutside, {{"u_bump", 0, {}}})},
      {"j", keyWith(CaseClass::kOutside, {{"u_cable", 0, {}}})},
  };
  Answers answers{
      {"a", answerWith("named", {{"coulomb", {{"friction", 0.102}}, {{"friction", {0.09, 0.11}}}}})},
      {"b", answerWith("named", {{"joint_flex", {{"stiffness", 20}}, {}}})},
      {"c", answerWith("ambiguous", {{"coulomb", {}, {}}})},
      {"d", answerWith("none")},
      {"e", answerWith("none")},
      {"f", answerWith("named", {{"inertia", {}, {}}})},
      {"g", answerWith("named", {{"coulomb", {}, {}}, {"cogging", {}, {}}})},
      {"h", answerWith("named", {{"viscous", {}, {}}})},
      {"i", answerWith("unknown")},
      {"j", answerWith("unknown")},
  };
  HandMade() {
    answers["c"].ambiguity = {{"coulomb", "deadband"}};
    keys["i"].places = {{"fit_3.csv", 1.0, 1.5}};
    answers["i"].places = {{"fit_1.csv", 0, 1, ""}, {"fit_3.csv", 1.4, 2, ""}};
    keys["j"].places = {{"fit_3.csv", 1.0, 1.5}};
    answers["j"].places = {{"fit_3.csv", 3.0, 3.5, ""}};
  }
};

TEST(Wilson, IsAsInTheTables) {
  EXPECT_NEAR(wilson(8, 10).first, 0.4902, 1e-4);
  EXPECT_NEAR(wilson(8, 10).second, 0.9433, 1e-4);
  EXPECT_NEAR(wilson(0, 10).first, 0, 1e-12);
  EXPECT_NEAR(wilson(0, 10).second, 0.2775, 1e-4);
  EXPECT_EQ(wilson(0, 0), std::make_pair(0.0, 1.0));
}

TEST(Score, CountsWhatIsRight) {
  const HandMade made;
  const Score score = scoreOf(made.keys, made.answers);
  EXPECT_EQ(score.cases, 10u);
  expectShare(share(score, figures::kExactNumbers), 1, 2);
  expectShare(share(score, figures::kWrongNumbers), 0, 1);
  expectShare(share(score, figures::kWeak), 0, 1);
  expectShare(share(score, figures::kHonest), 2, 4);
  expectShare(share(score, figures::kInterval), 1, 1);
  expectShare(share(score, figures::kFalseAlarm), 1, 2);
  expectShare(share(score, figures::kBothOfTwo), 1, 2);
  expectShare(share(score, figures::kFirstOfTwo), 2, 2);
  expectShare(share(score, figures::kOutsideUnknown), 1, 2);
  expectShare(share(score, figures::kOutsideNamed), 0, 2);
  expectShare(share(score, figures::kBlock), 0, 0);  // no answer has one
  EXPECT_FALSE(share(score, figures::kFalseAlarm).reached());
  EXPECT_TRUE(share(score, figures::kFirstOfTwo).reached());
}

TEST(Score, MeasuresNumbers) {
  HandMade made;
  made.answers["a"].after_rad = 0.004;
  const Score score = scoreOf(made.keys, made.answers);
  ASSERT_EQ(spread(score, figures::kParameterError).values.size(), 1u);
  EXPECT_NEAR(spread(score, figures::kParameterError).values[0], 2, 1e-9);  // %
  // 2 mrad five times and 4 mrad once, over a floor of 1 mrad and from 20 mrad.
  EXPECT_NEAR(spread(score, figures::kGapOverFloor).quantile(0.5), 2, 1e-9);
  EXPECT_NEAR(spread(score, figures::kGapOverFloor).quantile(0.9), 3, 1e-9);
  EXPECT_NEAR(spread(score, figures::kGapOverBefore).quantile(1), 0.2, 1e-9);
  EXPECT_FALSE(spread(score, figures::kGapOverFloor).reached());
  EXPECT_TRUE(spread(score, figures::kRuntime).reached());
}

TEST(Score, ListsConfusions) {
  const HandMade made;
  const Score score = scoreOf(made.keys, made.answers);
  const std::string text = asText(score);
  for (const char* line : {"backlash -> joint_flex  (b)", "stribeck -> nothing  (d)", "nothing -> inertia  (f)",
                           "deadband -> ambiguous: coulomb or deadband  (c)", "viscous + deadband -> viscous  (h)",
                           "u_cable -> unknown, another place  (j)"})
    EXPECT_THAT(text, HasSubstr(line));
  EXPECT_THAT(text, HasSubstr("nothing hidden, and the answers that are wrong\n\n   1  nothing -> inertia"));
  EXPECT_EQ(score.confusions.size(), 6u);
  const auto json = asJson(score);
  EXPECT_EQ(json.at("shares").at(0).at("right"), 1);
  EXPECT_NEAR(json.at("shares").at(0).at("low").get<double>(), wilson(1, 2).first, 1e-12);
  EXPECT_TRUE(json.at("shares").back().at("share").is_null());
  EXPECT_EQ(json.at("confusions").size(), 6u);
}

TEST(Score, CountsNoAnswerAndALateOneAsWrong) {
  HandMade made;
  made.answers.erase("g");
  made.answers["a"].runtime_s = 181;
  made.answers["zz"] = answerWith("none");
  const Score score = scoreOf(made.keys, made.answers);
  expectShare(share(score, figures::kExactNumbers), 0, 2);
  expectShare(share(score, figures::kBothOfTwo), 0, 2);
  EXPECT_THAT(score.unanswered, ElementsAre("a", "g"));
  EXPECT_THAT(score.without_key, ElementsAre("zz"));
  EXPECT_FALSE(spread(score, figures::kRuntime).reached());
}

TEST(Score, CountsNoAnswerToANullAsAnAlarm) {
  HandMade made;
  made.answers["e"] = answerWith("error");  // a crash
  expectShare(share(scoreOf(made.keys, made.answers), figures::kFalseAlarm), 2, 2);
  made.answers["e"] = answerWith("bad_input");  // the data are good
  expectShare(share(scoreOf(made.keys, made.answers), figures::kFalseAlarm), 2, 2);
  made.answers["e"] = answerWith("cannot_tell");  // honest
  expectShare(share(scoreOf(made.keys, made.answers), figures::kFalseAlarm), 1, 2);
}

TEST(Score, SplitsBySeverityAndNumbers) {
  const HandMade made;
  const Score score = scoreOf(made.keys, made.answers);
  const auto detail = [&](const std::string& what) {
    for (const ShareFigure& figure : score.details)
      if (figure.what == what) return figure;
    throw std::logic_error("no detail " + what);
  };
  expectShare(detail("severity 2, exact numbers: named first"), 1, 1);
  expectShare(detail("severity 2, wrong numbers: named first"), 0, 1);
  expectShare(detail("severity 2, wrong numbers: or ambiguous"), 1, 1);
  expectShare(detail("severity 1, exact numbers: named first"), 0, 1);
  expectShare(detail("effect-free, exact numbers: false alarm"), 0, 1);
  expectShare(detail("effect-free, wrong numbers: false alarm"), 1, 1);
  EXPECT_THAT(asText(score), HasSubstr("\nin detail\n\nseverity 1, exact numbers: named first"));
  EXPECT_EQ(asJson(score).at("details").size(), score.details.size());
}

TEST(Score, ReportsTheShareOfFairAnswers) {
  const HandMade made;
  const Score score = scoreOf(made.keys, made.answers);
  // a, c (ambiguous), e, g, h (the first is right), i, j (unknown): not b, d and f.
  expectShare(score.fair, 7, 10);
  EXPECT_TRUE(isBelow(score, 0.9)) << "the interval of 7 of 10 ends at 89.2 %";
  EXPECT_FALSE(isBelow(score, 0.89));
}

TEST(Score, AnAnswerWithAFalseNameBesideTheRightOneIsNotFair) {
  HandMade made;
  made.answers["a"].effects.push_back({"backlash", {}, {}});
  made.answers["c"].effects.push_back({"backlash", {}, {}});
  made.answers["c"].ambiguity.front().push_back("backlash");
  expectShare(scoreOf(made.keys, made.answers).fair, 6, 10);
}

TEST(Score, CountsOneNameTooManyAsWrong) {
  HandMade made;
  made.answers["g"].effects.push_back({"backlash", {}, {}});
  made.answers["j"].effects.push_back({"backlash", {}, {}});
  const Score score = scoreOf(made.keys, made.answers);
  expectShare(share(score, figures::kBothOfTwo), 0, 2);
  expectShare(share(score, figures::kFirstOfTwo), 2, 2);
  expectShare(share(score, figures::kOutsideNamed), 1, 2);
}

TEST(Score, JudgesTheBlockOfTheLoop) {
  HandMade made;
  made.answers["a"].places = {{"fit_1.csv", 0, 1, "plant"}};
  made.answers["c"].places = {{"fit_1.csv", 0, 1, "plant"}};  // a dead band is the controller's
  const Score score = scoreOf(made.keys, made.answers);
  expectShare(share(score, figures::kBlock), 1, 8);
  made.answers["c"].block = "controller";  // what the answer says as a whole goes before the strongest place
  expectShare(share(scoreOf(made.keys, made.answers), figures::kBlock), 2, 8);
}

TEST(Score, JudgesTheFirstOpenBlockByItself) {
  HandMade made;
  expectShare(share(scoreOf(made.keys, made.answers), figures::kFirstOpenBlock), 0, 0);  // no answer has one
  made.answers["a"].first_open_block = made.answers["b"].first_open_block = made.answers["c"].first_open_block =
      "plant";
  made.answers["c"].block = "controller";  // a dead band is the controller's
  expectShare(share(scoreOf(made.keys, made.answers), figures::kFirstOpenBlock), 2, 8);
}

TEST(ParameterNames, AreThoseOfManySuites) {
  const auto of = [](const char* effect, const char* name) {
    const auto found = parameterOf(effect, name);
    return found ? std::string{found->key} : "nothing";
  };
  EXPECT_EQ(of("coulomb", "Fc"), "friction");
  EXPECT_EQ(of("coulomb", "coulomb_Nm"), "friction");
  EXPECT_EQ(of("coulomb", "coulomb.friction"), "friction");
  EXPECT_EQ(of("coulomb", "friction_Nm"), "friction");
  EXPECT_EQ(of("stribeck", "ws"), "speed");
  EXPECT_EQ(of("directional_load_friction", "slow_motor"), "slow_motor");
  EXPECT_EQ(of("transport_delay", "delay"), "delay");
  EXPECT_EQ(of("p_on_torque", "motor"), "nothing");
  EXPECT_EQ(of("u_slosh", "u3_m"), "nothing");
  EXPECT_NEAR(inCatalogueNames("com_mass", {{"m_fac", 1.08}}).at("mass"), 0.08, 1e-12);
  EXPECT_NEAR(relativeError("gear_scale", "scale", 0.96, 0.95).value(), 0.2, 1e-9);
  EXPECT_NEAR(relativeError("coulomb", "friction", 0.11, 0.1).value(), 0.1, 1e-9);
  EXPECT_FALSE(relativeError("cogging", "phase", 1, 2).has_value());
}

TEST(Keys, AreReadAsTheyWereWritten) {
  const TemporaryFolder folder;
  const HandMade made;
  writeKeys(made.keys, folder / "key.json");
  const Keys back = readKeys(folder / "key.json");
  ASSERT_EQ(back.size(), made.keys.size());
  for (const auto& [name, key] : made.keys) {
    const Key& read = back.at(name);
    EXPECT_EQ(read.kind, key.kind) << name;
    EXPECT_EQ(read.exact, key.exact) << name;
    ASSERT_EQ(read.effects.size(), key.effects.size());
    for (std::size_t i = 0; i < key.effects.size(); ++i) {
      EXPECT_EQ(read.effects[i].id, key.effects[i].id);
      EXPECT_EQ(read.effects[i].severity, key.effects[i].severity);
      EXPECT_EQ(read.effects[i].values, key.effects[i].values);
    }
    EXPECT_EQ(read.places.size(), key.places.size());
    EXPECT_NEAR(read.noise_held_out_rad, key.noise_held_out_rad, 1e-9);
  }
}

std::string scoreFileError(const std::string& text) {
  const TemporaryFolder folder;
  std::ofstream{folder / "results.json"} << text;
  try {
    (void)readAnswers(folder / "results.json");
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

std::string refusalOf(const std::function<void()>& read) {
  try {
    read();
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

TEST(Answers, APipeInPlaceOfAFileIsRefusedAtOnce) {
  const TemporaryFolder folder;
  const std::string pipe = folder / "pipe.json";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_THAT(refusalOf([&] { (void)readAnswers(pipe); }), HasSubstr(kPipeInsteadOfFile));
  EXPECT_THAT(refusalOf([&] { (void)readKeys(pipe); }), HasSubstr(kPipeInsteadOfFile));
}

TEST(Answers, AreRefusedWithFileAndCase) {
  EXPECT_EQ(scoreFileError(R"([{"case":"a","verdict":"none","gap_score_after_mrad":null}])"), "");
  EXPECT_EQ(scoreFileError(
                R"([{"case":"a","verdict":"none","block":null,"where":[{"file":"f","t0":0,"t1":1,"block":null}]}])"),
            "");
  EXPECT_THAT(scoreFileError("{}"), HasSubstr("results.json: expected a list"));
  EXPECT_THAT(scoreFileError("[{"), HasSubstr("results.json: "));
  EXPECT_THAT(scoreFileError(R"([{"case":"a"}])"), HasSubstr("results.json, case a: "));
  EXPECT_THAT(scoreFileError(R"([{"case":"a","verdict":"none"},{"case":"a","verdict":"none"}])"),
              HasSubstr("case a: has two results"));
}

TEST(ExampleKey, GivesTheFullScoreToItsOwnAnswers) {
  const std::filesystem::path path = sharedData("gap-cases");
  if (!std::filesystem::exists(path / "key.json")) GTEST_SKIP() << "no example key in " << path;
  const Keys keys = readKeys((path / "key.json").string());
  EXPECT_EQ(keys.size(), 32u);
  constexpr std::array<const char*, 4> kVerdicts{"named", "none", "named", "unknown"};
  Answers answers;
  for (const auto& [name, key] : keys) {
    CaseAnswer answer = answerWith(kVerdicts[static_cast<std::size_t>(key.kind)]);
    answer.after_rad = key.noise_held_out_rad;
    for (const KeyEffect& effect : key.effects) {
      if (key.kind == CaseClass::kOutside) break;
      answer.effects.push_back({effect.id, inCatalogueNames(effect.id, effect.values), {}});
      if (effect.id != "p_on_torque") {
        EXPECT_EQ(answer.effects.back().values.size(), effect.values.size()) << name << " " << effect.id;
      }
    }
    answers[name] = answer;
  }
  const Score score = scoreOf(keys, answers);
  EXPECT_THAT(score.confusions, testing::IsEmpty());
  for (const ShareFigure& figure : score.shares) EXPECT_TRUE(figure.reached()) << figure.what;
  EXPECT_NEAR(spread(score, figures::kParameterError).quantile(1), 0, 1e-9);
  EXPECT_NEAR(spread(score, figures::kGapOverFloor).quantile(1), 1, 1e-3);
}

// Format 1 had the key `opens`; `first_open_block` is that of format 2.
TEST(Answers, OfTheFormerFormatAreRead) {
  const TemporaryFolder folder;
  std::ofstream{folder / "results.json"} << R"([{"case": "old", "verdict": "none", "opens": "plant"},
    {"format": 2, "case": "new", "verdict": "none", "first_open_block": "command"}])";
  const Answers answers = readAnswers(folder / "results.json");
  EXPECT_EQ(answers.at("old").first_open_block, "plant");
  EXPECT_EQ(answers.at("new").first_open_block, "command");
}

}  // namespace
}  // namespace darwinop::gap
