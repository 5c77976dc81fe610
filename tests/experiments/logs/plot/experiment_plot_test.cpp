// Plots of the 2013 experiments from synthetic logs with known results.
#include "experiments/logs/plot/experiment_plot.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "experiments/logs/plot/make_figure.hpp"
#include "experiments/logs/plot/messages.hpp"
#include "experiments/logs/read_log.hpp"

namespace darwinop::plot {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// A synthetic log of an experiment: rows of 16 ms, the first 10 before the state "driven".
class ExperimentLog {
 public:
  ExperimentLog(const std::string& experiment, const std::string& columns)
      : text_{"# safety.state: 0 offline 1 limp 4 driven\n# experiment: " + experiment + "\ntime_s,safety.state," +
              columns + "\n"} {}

  void row(const std::vector<double>& values, int state = 4) {
    text_ += std::to_string(0.016 * rows_++) + "," + std::to_string(state);
    for (const double value : values) text_ += "," + (std::isnan(value) ? "" : std::to_string(value));
    text_ += "\n";
  }
  [[nodiscard]] Figure figure() const {
    return makeFigure({logs::parseLog(text_, "run.csv")}, {{"run.csv"}, "", {}, ""});
  }

 private:
  std::string text_;
  int rows_ = 0;
};

TEST(ExperimentPlot, SpeedIsTimePerSweepOverTheSetting) {
  ExperimentLog run{"speed", "Neck.asked [rad],Neck.asked_speed [rad/s],Neck.position [rad]"};
  double neck = 0;
  for (int i = 0; i < 10; ++i) run.row({0, 1, neck}, 1);
  for (int i = 0; i < 10; ++i) run.row({0, 1, neck});
  for (const double speed : {2.0, 1.0})
    for (const double goal : {1.5, -1.5, 1.5})
      for (int i = 0; i < 400; ++i) {
        run.row({goal, speed, neck});
        neck += std::clamp(goal - neck, -speed * 0.016, speed * 0.016);
      }
  const Figure figure = run.figure();
  EXPECT_EQ(figure.title, std::string{"speed: "} + messages::kSweepTimes);
  EXPECT_EQ(figure.x_label, messages::kSpeedSetting);
  ASSERT_EQ(figure.panels.size(), 1u);
  const Curve& curve = figure.panels[0].curves.at(0);
  // The motion from 0 to the first goal is not a sweep; the goal of the second speed is already set.
  EXPECT_THAT(curve.x, ElementsAre(1, 1, 2, 2));
  // 3 rad minus the arrival tolerance of 0.05 rad; resolution one row of 16 ms.
  EXPECT_NEAR(curve.y[0], 2.95 / 1, 0.02);
  EXPECT_NEAR(curve.y[3], 2.95 / 2, 0.02);
}

TEST(ExperimentPlot, SweepWithOvershootEndsWhenItStaysAtTheGoal) {
  ExperimentLog run{"speed", "Neck.asked [rad],Neck.asked_speed [rad/s],Neck.position [rad]"};
  for (int i = 0; i < 10; ++i) run.row({-1.5, 1, -1.5}, 1);
  for (int i = 0; i < 10; ++i) run.row({-1.5, 1, -1.5});
  for (int i = 0; i < 100; ++i) run.row({1.5, 1, i < 10 ? -1.5 : i == 10 ? 1.5 : i < 30 ? 1.7 : 1.52});
  const Curve curve = run.figure().panels.at(0).curves.at(0);
  EXPECT_THAT(curve.x, ElementsAre(1));
  EXPECT_NEAR(curve.y.at(0), 30 * 0.016, 1e-6) << "not at row 10, which is an overshoot";
}

TEST(ExperimentPlot, AReadingThatIsMissingAfterTheArrivalDoesNotMoveIt) {
  ExperimentLog run{"speed", "Neck.asked [rad],Neck.asked_speed [rad/s],Neck.position [rad]"};
  for (int i = 0; i < 10; ++i) run.row({-1.5, 1, -1.5}, 1);
  for (int i = 0; i < 10; ++i) run.row({-1.5, 1, -1.5});
  for (int i = 0; i < 100; ++i) run.row({1.5, 1, i < 30 ? -1.5 : i == 60 ? NAN : 1.5});
  EXPECT_NEAR(run.figure().panels.at(0).curves.at(0).y.at(0), 30 * 0.016, 1e-6);
}

TEST(ExperimentPlot, DampingStartsAtTheRelease) {
  ExperimentLog run{"damping", "ShoulderR.asked [rad],ShoulderR.asked_torque [N m],ShoulderR.position [rad]"};
  for (int i = 0; i < 10; ++i) run.row({NAN, NAN, 0}, 1);
  for (int i = 0; i < 50; ++i) run.row({i < 5 ? 0.0 : 1.5, 2.5, 1.5});
  for (int i = 0; i < 50; ++i) run.row({1.5, 0, 1.5 * std::cos(0.1 * i)});
  const Figure figure = run.figure();
  EXPECT_EQ(figure.x_label, messages::kTimeSinceRelease);
  const Curve& curve = figure.panels.at(0).curves.at(0);
  ASSERT_EQ(curve.x.size(), 50u);
  EXPECT_EQ(curve.x.front(), 0);
  EXPECT_NEAR(curve.y.front(), 1.5, 1e-6);
  EXPECT_EQ(figure.panels[0].y_label, "angle of ShoulderR [rad]");
}

TEST(ExperimentPlot, GainsAreOverlaidFromTheirSteps) {
  ExperimentLog run{"p_gain", "ArmUpperR.asked [rad],ArmUpperR.asked_p_gain,ArmUpperR.position [rad]"};
  for (int i = 0; i < 10; ++i) run.row({-0.6, 1, -0.6}, 1);
  for (const double gain : {1.0, 4.0})
    for (const double goal : {-0.6, 0.8})
      for (int i = 0; i < 30; ++i) run.row({goal, gain, goal > 0 ? 0.8 - 0.2 / gain : -0.6});
  const Figure figure = run.figure();
  ASSERT_EQ(figure.panels.size(), 1u);
  ASSERT_EQ(figure.panels[0].curves.size(), 2u) << "the return is not shown";
  EXPECT_EQ(figure.panels[0].curves[0].label, "P = 1");
  EXPECT_EQ(figure.panels[0].curves[1].label, "P = 4");
  for (const Curve& curve : figure.panels[0].curves) EXPECT_EQ(curve.x.front(), 0);
  EXPECT_NEAR(figure.panels[0].curves[1].y.back(), 0.75, 1e-6);
}

TEST(ExperimentPlot, DampingOverlaysRepeatedReleases) {
  ExperimentLog run{"damping", "ShoulderR.asked [rad],ShoulderR.asked_torque_on,ShoulderR.position [rad]"};
  for (int i = 0; i < 10; ++i) run.row({0, NAN, 0}, 1);
  for (int round = 0; round < 2; ++round) {
    for (int i = 0; i < 20; ++i) run.row({0.1 * i, 1, 0.1 * i});
    for (int i = 0; i < 30; ++i) run.row({NAN, 0, 1.0 / (1 + round + i)});
  }
  const Figure figure = run.figure();
  ASSERT_EQ(figure.panels.at(0).curves.size(), 2u);
  EXPECT_EQ(figure.panels[0].curves[1].label, "release 2");
  EXPECT_EQ(figure.panels[0].curves[1].x.front(), 0);
  EXPECT_EQ(figure.panels[0].curves[1].x.size(), 30u);
  EXPECT_NEAR(figure.panels[0].curves[1].y.front(), 0.5, 1e-6);
}

TEST(ExperimentPlot, TorqueFeedbackIsLoadOverAngleDuringSlowRamps) {
  ExperimentLog run{"torque_feedback", "ArmUpperR.asked [rad],ArmUpperR.position [rad],ArmUpperR.load"};
  for (int i = 0; i < 10; ++i) run.row({0, 0, 0}, 1);
  for (int i = 0; i < 100; ++i) run.row({0.008 * i, 0.008 * i, 0.9});  // to the initial position, 0.5 rad/s
  double angle = 0.8;
  for (const int way : {-1, 1})
    for (int i = 0; i < 500; ++i) {  // 0.1 rad/s
      angle += way * 0.0016;
      run.row({angle, angle, 0.1 * way});
    }
  const Figure figure = run.figure();
  ASSERT_EQ(figure.panels.size(), 1u);
  ASSERT_EQ(figure.panels[0].curves.size(), 2u);
  EXPECT_EQ(figure.panels[0].curves[0].label, messages::kAngleFalling);
  EXPECT_EQ(figure.panels[0].curves[1].label, messages::kAngleRising);
  for (const Curve& curve : figure.panels[0].curves) {
    // The slow ramp without the rows near its ends, where the direction is ambiguous.
    EXPECT_NEAR(static_cast<double>(curve.x.size()), 500, 10);
    const auto fast = std::count(curve.y.begin(), curve.y.end(), 0.9);
    EXPECT_LE(fast, 4);
  }
}

TEST(ExperimentPlot, MaximumTorqueIsAngleOverTheRisingLimit) {
  ExperimentLog run{"max_torque", "ArmUpperR.asked [rad],ArmUpperR.asked_torque [N m],ArmUpperR.position [rad]"};
  for (int i = 0; i < 10; ++i) run.row({-0.6, NAN, 0}, 1);
  for (int i = 0; i < 10; ++i) run.row({-0.5, NAN, 0});
  for (int i = 0; i <= 60; ++i) run.row({0.8, 0.01 * i, 0.02 * i});
  for (int i = 0; i < 30; ++i) run.row({0.8, 2.5, 0.8});  // return at full torque
  const Figure figure = run.figure();
  const Curve& curve = figure.panels.at(0).curves.at(0);
  ASSERT_EQ(curve.x.size(), 61u);
  EXPECT_NEAR(curve.x.back(), 0.6, 1e-6);
  EXPECT_NEAR(curve.y.back(), 1.2, 1e-6);
}

TEST(ExperimentPlot, BowIsTheAccelerometerOverTheAnkleAngle) {
  ExperimentLog run{"bow_forward",
                    "accelerometer.x [m/s2],accelerometer.y [m/s2],accelerometer.z [m/s2],AnkleR.asked [rad],"
                    "AnkleR.position [rad]"};
  for (int i = 0; i < 10; ++i) run.row({0, 0, 9.8, 1, 1}, 1);
  for (int i = 0; i < 50; ++i) run.row({9, 9, 9, 1 - 0.02 * i, 1 - 0.02 * i});  // standing up
  for (int i = 0; i < 500; ++i) run.row({0.01 * i, 0, 9.8, 0.0005 * i, 0.0005 * i});
  const Figure figure = run.figure();
  EXPECT_EQ(figure.x_label, messages::kAnkleAngle);
  ASSERT_EQ(figure.panels.at(0).curves.size(), 3u);
  const Curve& x = figure.panels[0].curves[0];
  EXPECT_NEAR(*std::max_element(x.x.begin(), x.x.end()), 0.2495, 1e-6);
  EXPECT_NEAR(x.y[x.y.size() - 2], 4.99, 1e-6) << "the last point is a gap";
}

TEST(ExperimentPlot, BowEndsAtTheFall) {
  ExperimentLog run{"bow_forward",
                    "accelerometer.x [m/s2],accelerometer.y [m/s2],accelerometer.z [m/s2],AnkleR.asked [rad],"
                    "AnkleR.position [rad]"};
  for (int i = 0; i < 10; ++i) run.row({0, 0, 9.8, 0, 0}, 1);
  for (int i = 0; i < 500; ++i) run.row({0, i < 400 ? -4.0 : 0, i < 400 ? 9.0 : 3, 0.0005 * i, 0.0005 * i});
  const Figure figure = run.figure();
  for (const Curve& curve : figure.panels.at(0).curves)
    EXPECT_NEAR(*std::max_element(curve.x.begin(), curve.x.end()), 0.0005 * 399, 1e-6);
}

TEST(ExperimentPlot, RowsAfterTheExperimentAreNotShown) {
  ExperimentLog run{"gyroscope", "gyro.x [rad/s],Neck.asked [rad],Neck.position [rad]"};
  for (int i = 0; i < 10; ++i) run.row({0, 0, 0}, 1);
  for (int i = 0; i < 20; ++i) run.row({0.1, 0.1 * i, 0.1 * i});
  for (int i = 0; i < 10; ++i) run.row({7, 2, 2}, 1);  // torque goes off, the robot falls
  const Curve curve = run.figure().panels.at(0).curves.at(0);
  EXPECT_NEAR(curve.x.front(), 0, 1e-9);
  EXPECT_EQ(*std::max_element(curve.y.begin(), curve.y.end() - 1), 0.1) << "the last point is a gap";
}

TEST(ExperimentPlot, TimeStartsAtTheFirstNewGoal) {
  ExperimentLog run{"chirp", "Neck.asked [rad],Neck.position [rad]"};
  for (int i = 0; i < 10; ++i) run.row({NAN, 0}, 1);
  for (int i = 0; i < 5; ++i) run.row({0, 0});
  for (int i = 0; i < 10; ++i) run.row({0.1 * i + 0.1, 0.1 * i});
  const Figure figure = run.figure();
  const Curve& curve = figure.panels.at(0).curves.at(0);
  EXPECT_NEAR(curve.x.at(15), 0, 1e-9);
  EXPECT_NEAR(curve.x.front(), -15 * 0.016, 1e-9);
}

TEST(ExperimentPlot, OtherExperimentsShowTheJointsAndSensorsInTheirHeader) {
  ExperimentLog run{"chirp\n# title: a sweep\n# joints: Head\n# sensors: gyro",
                    "Neck.asked [rad],Neck.position [rad],Head.position [rad],gyro.x [rad/s],accelerometer.x [m/s2]"};
  for (int i = 0; i < 10; ++i) run.row({0.1 * i, 0.1 * i, 0.01 * i, 0.1 * i, 0.1 * i});
  const Figure figure = run.figure();
  EXPECT_EQ(figure.title, "chirp: a sweep");
  ASSERT_EQ(figure.panels.size(), 2u);
  EXPECT_EQ(figure.panels[0].title, "Head");
  EXPECT_EQ(figure.panels[1].title, "gyro");
}

TEST(ExperimentPlot, IsChosenByWholeWordsOfTheName) {
  const auto title_for = [](const char* name) {
    const auto* const plot = experimentPlot(
        logs::parseLog(std::string{"# experiment: "} + name + "\ntime_s,Neck.position [rad]\n0,0\n", "l"));
    return plot == nullptr ? "" : std::string{plot->title};
  };
  EXPECT_NE(title_for("bow_forward"), "");
  EXPECT_EQ(title_for("my bow"), title_for("bow_forward"));
  EXPECT_NE(title_for("release"), "");
  for (const char* const other : {"elbow_ramp", "again", "body_release"}) EXPECT_EQ(title_for(other), "") << other;
}

TEST(ExperimentPlot, ALogWithoutTheDataShowsDefaultCurvesAndANote) {
  ExperimentLog run{"damping", "ShoulderR.asked [rad],ShoulderR.position [rad]"};
  for (int i = 0; i < 10; ++i) run.row({0.1 * i, 0.1 * i});
  const Figure figure = run.figure();
  EXPECT_EQ(figure.panels.at(0).curves.size(), 2u);
  EXPECT_THAT(figure.notes, ElementsAre(HasSubstr("run.csv lacks data for this plot: released arm")));
}

}  // namespace
}  // namespace darwinop::plot
