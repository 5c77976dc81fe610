// Selection and grouping of curves.
#include <gmock/gmock.h>

#include <cmath>
#include <stdexcept>

#include "experiments/logs/plot/make_figure.hpp"
#include "experiments/logs/plot/messages.hpp"
#include "experiments/logs/plot/text.hpp"
#include "some_logs.hpp"

namespace darwinop::plot {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

std::vector<std::string> titles(const Figure& figure) {
  std::vector<std::string> all;
  for (const Panel& panel : figure.panels) all.push_back(panel.title);
  return all;
}

std::vector<std::string> labels(const Panel& panel) {
  std::vector<std::string> all;
  for (const Curve& curve : panel.curves) all.push_back(curve.label);
  return all;
}

std::string refusal(const std::vector<logs::Log>& all, const PlotOptions& options) {
  try {
    (void)makeFigure(all, options);
    return "";
  } catch (const std::runtime_error& error) {
    return error.what();
  }
}

PlotOptions options(const std::vector<std::string>& columns = {}, const std::string& x = "") {
  return {{"walk.csv"}, "", columns, x};
}

TEST(Figure, ShowsGoalPositionAndLoadOfMovingJointsAndTheSensors) {
  const Figure figure = makeFigure({twoJoints("walk.csv")}, options());
  EXPECT_THAT(titles(figure), ElementsAre("Neck", "load", "gyro"));
  EXPECT_THAT(labels(figure.panels[0]), ElementsAre("goal", "measured"));
  EXPECT_TRUE(figure.panels[0].curves[0].dashed);
  EXPECT_FALSE(figure.panels[0].curves[1].dashed);
  EXPECT_EQ(figure.panels[0].curves[0].colour, figure.panels[0].curves[1].colour) << "one colour per quantity";
  EXPECT_EQ(figure.panels[0].y_label, "angle [rad]");
  EXPECT_EQ(figure.x_label, "time [s]");
  EXPECT_THAT(figure.panels[0].curves[1].x, ElementsAre(0, 1, 2)) << "from the start of the log";
}

TEST(Figure, OverlaysLogsFromTheirOwnStartWithOneColourPerLog) {
  const Figure figure = makeFigure({twoJoints("a/walk.csv", 10), twoJoints("b/walk.csv", 500)}, options());
  EXPECT_THAT(titles(figure), ElementsAre("Neck", "load of Neck", "gyro.x", "gyro.y"));
  EXPECT_THAT(labels(figure.panels[0]), ElementsAre("a/walk, goal", "a/walk", "b/walk, goal", "b/walk"));
  EXPECT_THAT(figure.panels[0].curves[3].x, ElementsAre(0, 1, 2));
  for (const Panel& panel : figure.panels)
    for (const Curve& curve : panel.curves) EXPECT_EQ(curve.colour, curve.log);
}

TEST(Figure, LabelsContainTheModelsIfTheyDiffer) {
  const Figure figure = makeFigure({twoJoints("a.csv", 0, "twin"), twoJoints("b.csv", 0, "/dev/ttyUSB0")}, options());
  EXPECT_EQ(figure.sources[0].label, "a (twin)");
  EXPECT_EQ(figure.sources[1].label, "b (/dev/ttyUSB0)");
  EXPECT_EQ(figure.sources[1].robot, "Darwin 7");
}

TEST(Figure, LabelsOmitModelsThatDoNotFit) {
  const Figure figure = makeFigure({twoJoints("twin_p_gain.csv", 0, "twin in memory"),            // no message
                                    twoJoints("b.csv", 0, "twin in memory, model webots-2013")},  // no message
                                   options());
  EXPECT_EQ(figure.sources[0].label, "twin_p_gain");
  EXPECT_EQ(figure.sources[1].label, "b");
  EXPECT_EQ(figure.sources[1].model, "twin in memory, model webots-2013");
}

TEST(Figure, TheSameLogTwiceIsNumbered) {
  const Figure figure = makeFigure({twoJoints("a.csv"), twoJoints("a.csv")}, options());
  EXPECT_EQ(figure.sources[1].label, "a #2");
}

TEST(Figure, ShowsMatchingColumnsOverTheRequestedAxis) {
  const Figure figure = makeFigure({twoJoints("walk.csv")}, options({"Neck.*", "gyro.?"}, "Neck.position"));
  EXPECT_EQ(figure.x_label, "Neck.position [rad]");
  EXPECT_THAT(titles(figure), ElementsAre("rad/s", "rad", messages::kNoUnit));
  EXPECT_THAT(labels(figure.panels[1]), ElementsAre("Neck.asked", "Neck.position"));
  EXPECT_THAT(figure.panels[0].curves[0].x, ElementsAre(0, 0.5, testing::IsNan()));
}

TEST(Figure, ListsTheColumnsIfAPatternMatchesNothing) {
  EXPECT_THAT(refusal({twoJoints("walk.csv")}, options({"neck"})),
              HasSubstr("walk.csv: no column \"neck\"; available: time_s, gyro.x"));
  EXPECT_THAT(refusal({twoJoints("walk.csv")}, options({}, "ankle")), HasSubstr("no column \"ankle\""));
}

TEST(Figure, RefusesAnEmptyFigure) {
  EXPECT_THAT(refusal({logs::parseLog("t_s,pos_rad\n1,0\n2,0\n", "still.csv")}, options()),
              AllOf(HasSubstr(messages::kNothingMoves), HasSubstr("--columns")));
  EXPECT_THAT(refusal({logs::parseLog("t_s,pos_rad\n", "none.csv")}, options()), HasSubstr("none.csv has no rows"));
}

TEST(Figure, ShowsTheJointsThatMoveMostAndNotesTheOthers) {
  std::string names = "t_s", first = "0", second = "1";
  for (int i = 1; i <= 8; ++i) {
    names += ",J" + std::to_string(i) + ".position [rad]";
    first += ",0";
    second += "," + std::to_string(i == 3 ? 0.02 : 0.1 * i);
  }
  const Figure figure = makeFigure({logs::parseLog(names + "\n" + first + "\n" + second + "\n", "f")}, options());
  EXPECT_THAT(titles(figure), ElementsAre("J2", "J4", "J5", "J6", "J7", "J8"));
  EXPECT_THAT(figure.notes, ElementsAre(HasSubstr("also moving: J1, J3 ")));
}

TEST(Figure, ConnectsSparseValuesAndLeavesOtherGaps) {
  const logs::Log log =
      logs::parseLog("t_s,gyro.x [rad/s],volt_V\n0,1,12\n1,2,\n2,,\n3,3,11\n4,4,\n5,5,\n6,6,11.5\n", "f");
  const Figure figure = makeFigure({log}, {{"f"}, "", {"gyro.x", "volt_V"}, ""});
  const Curve& gyro = figure.panels.at(0).curves.at(0);
  EXPECT_EQ(gyro.style, Style::kLine);
  EXPECT_TRUE(std::isnan(gyro.y.at(2)));
  const Curve& voltage = figure.panels.at(1).curves.at(0);
  EXPECT_EQ(voltage.style, Style::kMarks);
  EXPECT_THAT(voltage.x, ElementsAre(0, 3, 6));
  EXPECT_THAT(voltage.y, ElementsAre(12, 11, 11.5));
}

TEST(Figure, NotesTheWarningsOfALog) {
  logs::Log log = twoJoints("walk.csv");
  log.warnings.push_back("walk.csv has no \"# end\"");
  EXPECT_THAT(makeFigure({log}, options()).notes, ElementsAre("walk.csv has no \"# end\""));
  EXPECT_THAT(makeFigure({twoJoints("walk.csv")}, options()).notes, IsEmpty());
}

TEST(Text, IsOneLineOfValidUtf8) {
  EXPECT_EQ(oneLine("a\nb\x1b[31m\x7f"), "a b [31m ");
  EXPECT_EQ(oneLine("Käfer … 机"), "Käfer … 机");
  EXPECT_EQ(oneLine("\xFF\xC3"), "??");
  EXPECT_EQ(oneLine("\xED\xA0\x80"), "???") << "half of a surrogate pair is invalid";
}

TEST(Text, IsCutBetweenCharacters) {
  EXPECT_EQ(shortened("äöü", 3), "äöü");
  EXPECT_EQ(shortened("äöüß", 3), "äö…");
}

}  // namespace
}  // namespace darwinop::plot
