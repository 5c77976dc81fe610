// What is drawn, before anybody draws it: panels of curves over one horizontal axis.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace darwinop::plot {

enum class Style { kLine, kMarks };  // kMarks: few samples, each one marked

inline constexpr std::size_t kLegend = 28;  // characters of a curve's label that a picture has room for

struct Curve {
  std::string label;
  std::size_t log = 0;     // index in Figure::sources
  std::size_t colour = 0;  // index in kColours
  bool dashed = false;     // a goal, as against what was measured
  Style style = Style::kLine;
  std::vector<double> x, y;  // not known, in either: the line has a gap
};

struct Panel {
  std::string title;
  std::string y_label;  // with unit
  std::vector<Curve> curves;
};

/// One log: what its curves are called, and where it comes from.
struct Source {
  std::string label, file, robot, model, version, date;
};

struct Figure {
  std::string title;
  std::string x_label;
  std::vector<Source> sources;
  std::vector<std::string> notes;  // what a reader has to know, such as joints that are not shown
  std::vector<Panel> panels;
  std::vector<double> marks = {};  // of the horizontal axis: a thin line through all panels, where something begins
};

/// Colours that stay apart for colour-blind eyes, on white and (the second) on black paper. Okabe and Ito, "Color
/// Universal Design", 2008, in an order in which neighbours differ in lightness too, so that grey print shows it; their
/// yellow is left out, as white paper swallows it.
struct Colour {
  const char *on_white, *on_black;
};
inline constexpr Colour kColours[] = {
    {"#0072B2", "#56B4E9"}, {"#E69F00", "#E69F00"}, {"#000000", "#FFFFFF"}, {"#009E73", "#00C090"},
    {"#CC79A7", "#E39BC4"}, {"#D55E00", "#FF8533"}, {"#56B4E9", "#3D85C6"},
};
inline constexpr std::size_t kColourCount = sizeof kColours / sizeof kColours[0];

}  // namespace darwinop::plot
