// A figure, independent of the output format: panels of curves over a common horizontal axis.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace darwinop::plot {

enum class Style { kLine, kMarks };  // kMarks: few samples, each marked

inline constexpr std::size_t kLegend = 28;  // maximum characters of a curve label in the picture

struct Curve {
  std::string label;
  std::size_t log = 0;     // index in Figure::sources
  std::size_t colour = 0;  // index in kColours
  bool dashed = false;     // a goal, not a measurement
  Style style = Style::kLine;
  std::vector<double> x, y;  // NaN in either: gap in the line
};

struct Panel {
  std::string title;
  std::string y_label;  // with unit
  std::vector<Curve> curves;
};

/// One log: label of its curves, and its origin.
struct Source {
  std::string label, file, robot, model, version, date;
};

struct Figure {
  std::string title;
  std::string x_label;
  std::vector<Source> sources;
  std::vector<std::string> notes;  // for the reader, such as joints that are not shown
  std::vector<Panel> panels;
  std::vector<double> marks = {};  // x values of vertical lines through all panels
};

/// Colours that are distinguishable with colour blindness, on white and on black background. Okabe and Ito, "Color
/// Universal Design", 2008, ordered so that neighbours also differ in lightness (for grey print); without yellow, which
/// is invisible on white.
struct Colour {
  const char *on_white, *on_black;
};
inline constexpr Colour kColours[] = {
    {"#0072B2", "#56B4E9"}, {"#E69F00", "#E69F00"}, {"#000000", "#FFFFFF"}, {"#009E73", "#00C090"},
    {"#CC79A7", "#E39BC4"}, {"#D55E00", "#FF8533"}, {"#56B4E9", "#3D85C6"},
};
inline constexpr std::size_t kColourCount = sizeof kColours / sizeof kColours[0];

}  // namespace darwinop::plot
