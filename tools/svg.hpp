// Just enough of SVG for pictures in docs: lines, curves, boxes, words. Pixels, y down.
#pragma once

#include <cmath>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

namespace darwinop::svg {

using Points = std::vector<std::pair<double, double>>;

/// The same on every machine: a value in the middle of two goes up, whatever its last bits are.
inline std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.1f", value + 1e-6);
  return std::string{text} == "-0.0" ? "0.0" : text;
}

class Picture {
 public:
  Picture(int width, int height)
      : text_{"<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + std::to_string(width) + "\" height=\"" +
              std::to_string(height) +
              "\" font-family=\"sans-serif\" font-size=\"12\">\n<rect width=\"100%\" height=\"100%\" "
              "fill=\"white\"/>\n"} {}

  void curve(const Points& points, const std::string& colour, double width = 2, const std::string& more = "") {
    std::string places;
    for (const auto& [x, y] : points) places += (places.empty() ? "" : " ") + number(x) + "," + number(y);
    text_ += "<polyline points=\"" + places + "\" fill=\"none\" stroke=\"" + colour + "\" stroke-width=\"" +
             number(width) + "\" stroke-linecap=\"round\" stroke-linejoin=\"round\" " + more + "/>\n";
  }
  void box(double x, double y, double width, double height, const std::string& colour) {
    text_ += "<rect x=\"" + number(x) + "\" y=\"" + number(y) + "\" width=\"" + number(width) + "\" height=\"" +
             number(height) + "\" fill=\"" + colour + "\"/>\n";
  }
  void closed(const Points& points, const std::string& stroke, const std::string& fill, const std::string& more = "") {
    std::string places;
    for (const auto& [x, y] : points) places += (places.empty() ? "" : " ") + number(x) + "," + number(y);
    text_ += "<polygon points=\"" + places + "\" fill=\"" + fill + "\" stroke=\"" + stroke + "\" " + more + "/>\n";
  }
  void dot(double x, double y, double radius, const std::string& colour) {
    text_ += "<circle cx=\"" + number(x) + "\" cy=\"" + number(y) + "\" r=\"" + number(radius) + "\" fill=\"" + colour +
             "\"/>\n";
  }
  /// `anchor`: start, middle, end.
  void words(double x, double y, const std::string& what, const std::string& anchor = "start",
             const std::string& colour = "#333", const std::string& more = "") {
    text_ += "<text x=\"" + number(x) + "\" y=\"" + number(y) + "\" text-anchor=\"" + anchor + "\" fill=\"" + colour +
             "\" " + more + ">" + what + "</text>\n";
  }
  /// A line with a head at its end, or at both.
  void arrow(double x1, double y1, double x2, double y2, bool both = false, const std::string& colour = "#333") {
    curve({{x1, y1}, {x2, y2}}, colour, 1.2);
    head(x1, y1, x2, y2, colour);
    if (both) head(x2, y2, x1, y1, colour);
  }

  [[nodiscard]] std::string text() const { return text_ + "</svg>\n"; }

 private:
  void head(double x1, double y1, double x2, double y2, const std::string& colour) {
    constexpr double kLong = 7, kHalf = 3;
    const double length = std::hypot(x2 - x1, y2 - y1), x = (x2 - x1) / length, y = (y2 - y1) / length;
    closed({{x2, y2},
            {x2 - kLong * x + kHalf * y, y2 - kLong * y - kHalf * x},
            {x2 - kLong * x - kHalf * y, y2 - kLong * y + kHalf * x}},
           colour, colour);
  }
  std::string text_;
};

}  // namespace darwinop::svg
