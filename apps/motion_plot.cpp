// `darwinop motion plot`: the goals of a page and of those that follow it, by limb.
#include "motion_plot.hpp"

#include <algorithm>
#include <array>
#include <fstream>
#include <iostream>
#include <set>
#include <stdexcept>
#include <string_view>
#include <vector>

#include "core/conversions.hpp"
#include "core/text/number_text.hpp"
#include "managers/motion_text/dry_run.hpp"
#include "managers/motion_text/values.hpp"
#include "motion_own.hpp"
#include "motion_print.hpp"
#if __has_include("experiments/logs/plot/figure.hpp")
#include "experiments/logs/plot/gnuplot.hpp"
#include "experiments/logs/plot/page.hpp"
#define DARWINOP_CAN_PLOT
#endif

namespace darwinop::motion {

#ifdef DARWINOP_CAN_PLOT

namespace {

constexpr double kPlotTick = kTickMs / 1000.0;  // s

struct Limb {
  std::string_view title;
  std::vector<Joint> joints;  // the same colour, the same joint
};

const std::array<Limb, 5>& limbs() {
  static const std::array<Limb, 5> all{{
      {"right leg",
       {Joint::kLegUpperR, Joint::kLegLowerR, Joint::kAnkleR, Joint::kPelvR, Joint::kFootR, Joint::kPelvYR}},
      {"left leg",
       {Joint::kLegUpperL, Joint::kLegLowerL, Joint::kAnkleL, Joint::kPelvL, Joint::kFootL, Joint::kPelvYL}},
      {"right arm", {Joint::kShoulderR, Joint::kArmUpperR, Joint::kArmLowerR}},
      {"left arm", {Joint::kShoulderL, Joint::kArmUpperL, Joint::kArmLowerL}},
      {"head", {Joint::kNeck, Joint::kHead}},
  }};
  return all;
}

/// "LegLowerR, P 32", or "P 32 8" when the pages that follow have others.
std::string labelOf(Joint joint, const PageFile& pages, const DryRun& played) {
  std::string label = std::string{row(joint).name} + ", P";
  std::set<int> seen;
  for (const DryRun::Section& section : played.sections) {
    const Page& page = pages.at(static_cast<std::size_t>(section.page));
    const int gain = pGainRegister(page.slopes.at(row(joint).id));
    if (seen.insert(gain).second) label += " " + std::to_string(gain);
  }
  return label;
}

plot::Panel panelOf(const Limb& limb, const PageFile& pages, const DryRun& played, const std::vector<double>& times) {
  plot::Panel panel{std::string{limb.title}, "angle [deg]", {}};
  for (const Joint joint : limb.joints) {
    plot::Curve curve;
    curve.label = labelOf(joint, pages, played);
    curve.colour = panel.curves.size();
    curve.x = times;
    for (const Pose& pose : played.poses) curve.y.push_back((pose[index(joint)] - kTickCentre) * kDegreesPerTick);
    panel.curves.push_back(std::move(curve));
  }
  return panel;
}

std::string stepsText(const DryRun& played, const DryRun::Section& section) {
  std::string text = "steps begin at";
  for (const std::size_t at : section.steps) text += " " + text::fixedText(static_cast<double>(at) * kPlotTick, 2);
  return text + " s" + (&section == &played.sections.back() ? "" : ", then:");
}

plot::Figure figureOf(const PageFile& pages, const PlotRequest& request) {
  const Page& page = usedPage(pages, request.page, request.file);
  const bool from_start = request.from == "start";
  Pose from = firstPose(page);
  if (from_start)
    for (std::size_t i = 0; i < kJoints; ++i) from[i] = kJointTable[i].start;
  const DryRun played = dryRun(pages, request.page, from);
  plot::Figure figure;
  figure.title = "page " + std::to_string(request.page) + " \"" + nameOf(page) + "\", " +
                 text::fixedText(static_cast<double>(played.poses.size() - 1) * kPlotTick, 2) + " s, from " +
                 (from_start ? "the start pose" : "its own first pose");
  figure.x_label = "time [s]; a thin line where a step begins. P: gain register";
  for (const DryRun::Section& section : played.sections) {
    const Page& one = pages.at(static_cast<std::size_t>(section.page));
    const std::string name = "page " + std::to_string(section.page) + " \"" + nameOf(one) + "\"";
    figure.sources.push_back({name, name + ": " + stepsText(played, section), "", "", "", ""});
    for (const std::size_t at : section.steps) figure.marks.push_back(static_cast<double>(at) * kPlotTick);
  }
  if (played.cut) figure.notes.emplace_back("it goes on: a ring of pages, or longer than a minute");
  std::vector<double> times;
  for (std::size_t i = 0; i < played.poses.size(); ++i) times.push_back(static_cast<double>(i) * kPlotTick);
  for (const Limb& limb : limbs()) figure.panels.push_back(panelOf(limb, pages, played, times));
  return figure;
}

}  // namespace

int plotPage(const PlotRequest& request) {
  const std::string_view out = request.out;
  if (!out.ends_with(".png") && !out.ends_with(".html"))
    throw std::runtime_error(request.out + ": expected a name ending in .png (an image) or .html (a page to zoom in)");
  const plot::Figure figure = figureOf(openMotions(request.file).pages, request);
  if (out.ends_with(".png")) {
    if (const std::string missing = plot::drawPicture(figure, request.out); !missing.empty())
      throw std::runtime_error(missing);
  } else {
    writeText(request.out, plot::htmlPage(figure));
  }
  std::cout << request.out << '\n';
  return 0;
}

#else

int plotPage(const PlotRequest&) {
  throw std::runtime_error("plotting is available on a PC only: run the same command there");
}

#endif

}  // namespace darwinop::motion
