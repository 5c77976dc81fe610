// Generates the gnuplot script of a figure.
#include <algorithm>
#include <cmath>

#include "core/text/number_text.hpp"
#include "experiments/logs/plot/gnuplot.hpp"
#include "experiments/logs/plot/text.hpp"

namespace darwinop::plot {
namespace {

// Pixels.
constexpr int kTitle = 44, kLine = 20, kAboveCurves = 24, kBelowCurves = 28, kAxis = 30;
constexpr int kLeft = 90, kRight = 250;  // the legend is to the right of the curves

/// Fewer panels are taller.
int panelHeight(const Figure& figure) {
  return figure.panels.size() == 1 ? 440 : figure.panels.size() == 2 ? 320 : 240;
}

int linesAbove(const Figure& figure) {
  return static_cast<int>(figure.sources.size() + figure.notes.size());
}

/// Single-quoted text, in which gnuplot interprets nothing; apostrophes become U+2019, which does not end it.
std::string text(const std::string& raw) {
  std::string quoted = "'";
  for (const char c : oneLine(raw)) quoted.append(c == '\'' ? "\u2019" : std::string(1, c));
  return quoted + "'";
}

class Script {
 public:
  explicit Script(const Figure& figure) : figure_{figure}, height_{pictureHeight(figure)} {}

  std::string write() {
    const std::string size = std::to_string(kPictureWidth) + "," + std::to_string(height_);
    line("set encoding utf8");
    line("set terminal pngcairo noenhanced rounded size " + size + " font 'sans,10'");
    line("set style data lines");
    line("set datafile separator whitespace");
    line("set grid linecolor rgb '#DDDDDD' linewidth 1");
    line("set border 3 linecolor rgb '#444444'");
    line("set tics nomirror");
    line("set key left top vertical Left reverse samplen 2 noenhanced font ',9'");
    data();
    for (const double mark : figure_.marks) {
      std::string at;
      at += text::generalText(mark, 10);
      std::string arrow = "set arrow from ";
      arrow.append(at).append(", graph 0 to ").append(at).append(", graph 1 nohead back");
      line(arrow.append(" dashtype (3,5) linecolor rgb '#888888'"));
    }
    line("set multiplot");
    labels();
    for (std::size_t i = 0; i < figure_.panels.size(); ++i) panel(i);
    line("unset multiplot");
    return std::move(out_);
  }

 private:
  void line(const std::string& command) { out_.append(command).append("\n"); }

  [[nodiscard]] std::string fromTop(int pixels) const {
    std::string share;
    share += text::generalText(1.0 - static_cast<double>(pixels) / height_, 6);
    return share;
  }
  static std::string fromLeft(int pixels) {
    std::string share;
    share += text::generalText(static_cast<double>(pixels) / kPictureWidth, 6);
    return share;
  }

  /// A blank line makes a gap in the curve.
  void data() {
    std::size_t number = 0;
    for (const Panel& panel : figure_.panels)
      for (const Curve& curve : panel.curves) {
        line("$d" + std::to_string(number++) + " << EOD");
        bool gap = true;  // none before the first point
        for (std::size_t i = 0; i < curve.x.size(); ++i) {
          const bool known = std::isfinite(curve.x[i]) && std::isfinite(curve.y[i]);
          if (known) {
            out_ += text::generalText(curve.x[i], 10);
            out_ += ' ';
            out_ += text::generalText(curve.y[i], 7);
          }
          if (known || !gap) out_ += '\n';
          gap = !known;
        }
        line("EOD");
      }
  }

  /// Title, origin of each log, notes. Drawn with the first panel.
  void labels() {
    line("set label 1 " + text(figure_.title) + " at screen 0.5," + fromTop(24) + " center font ',14'");
    int number = 2, y = kTitle + 6;
    const auto small = [&](const std::string& words, const std::string& colour) {
      line("set label " + std::to_string(number++) + " " + text(shortened(words, 170)) + " at screen 0.5," +
           fromTop(y) + " center font ',9' textcolor rgb '" + colour + "'");
      y += kLine;
    };
    for (const Source& source : figure_.sources) {
      std::string words = source.file;
      if (!source.robot.empty()) words += " · robot " + source.robot;
      if (!source.model.empty()) words += " · model " + source.model;
      if (!source.version.empty()) words += " · version " + source.version;
      if (!source.date.empty()) words += " · " + source.date;
      small(words, "#444444");
    }
    for (const std::string& note : figure_.notes) small(note, "#A03000");
  }

  void panel(std::size_t index) {
    const Panel& panel = figure_.panels[index];
    const int height = panelHeight(figure_);
    const int top = kTitle + kLine * linesAbove(figure_) + height * static_cast<int>(index);
    const bool last = index + 1 == figure_.panels.size();
    line("set lmargin at screen " + fromLeft(kLeft));
    line("set rmargin at screen " + fromLeft(kPictureWidth - kRight));
    line("set tmargin at screen " + fromTop(top + kAboveCurves));
    line("set bmargin at screen " + fromTop(top + height - kBelowCurves));
    line("set key at screen " + fromLeft(kPictureWidth - kRight + 16) + "," + fromTop(top + kAboveCurves));
    line("set title " + text(panel.title) + " offset 0,-0.6");
    line("set ylabel " + text(panel.y_label));
    line("set xlabel " + text(last ? figure_.x_label : ""));
    setRange();
    std::string plot = "plot ";
    for (std::size_t i = 0; i < panel.curves.size(); ++i) {
      if (i != 0) plot += ", ";
      plot += curve(panel.curves[i], next_data_++);
    }
    line(plot);
    line("unset label");
  }

  /// Common horizontal axis of all panels; a constant range is widened.
  void setRange() {
    double low = INFINITY, high = -INFINITY;
    for (const Panel& panel : figure_.panels)
      for (const Curve& curve : panel.curves)
        for (std::size_t i = 0; i < curve.x.size(); ++i)
          if (std::isfinite(curve.x[i]) && std::isfinite(curve.y[i])) {
            low = std::min(low, curve.x[i]);
            high = std::max(high, curve.x[i]);
          }
    if (!(low <= high)) return line("set xrange [0:1]\nset yrange [0:1]");
    const double margin = high > low ? 0.01 * (high - low) : 1;
    std::string range = "set xrange [";
    range += text::generalText(low - margin, 10);
    range += ':';
    range += text::generalText(high + margin, 10);
    line(range + "]");
  }

  static std::string curve(const Curve& curve, std::size_t data) {
    std::string words = "$d" + std::to_string(data) + " using 1:2 with ";
    words += curve.style == Style::kMarks ? "linespoints pointtype 7 pointsize 0.7" : "lines";
    words += std::string{" linewidth "} + (curve.dashed ? "1.3" : "1.8");
    const bool dashed = curve.dashed || curve.colour >= kColourCount;
    words += dashed ? " dashtype (12,8)" : " dashtype solid";
    words += std::string{" linecolor rgb '"} + kColours[curve.colour % kColourCount].on_white + "'";
    return words + " title " + text(shortened(curve.label, kLegend));
  }

  const Figure& figure_;
  int height_;
  std::string out_;
  std::size_t next_data_ = 0;
};

}  // namespace

int pictureHeight(const Figure& figure) {
  return kTitle + kLine * linesAbove(figure) + panelHeight(figure) * static_cast<int>(figure.panels.size()) + kAxis;
}

std::string gnuplotScript(const Figure& figure) {
  return Script{figure}.write();
}

}  // namespace darwinop::plot
