// Assembles the HTML file from the template in page/, the plotting library, and the figure as JSON.
#include "experiments/logs/plot/page.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/text/number_text.hpp"
#include "core/text/template.hpp"
#include "experiments/logs/plot/page_parts.hpp"
#include "experiments/logs/plot/text.hpp"

namespace darwinop::plot {
namespace {

/// Escapes "<", the only character that can end <script> or begin a comment.
std::string json(const std::string& raw) {
  std::string quoted = "\"";
  for (const char c : oneLine(raw)) {
    if (c == '<')
      quoted += "\\u003c";
    else if (c == '"' || c == '\\')
      quoted.append("\\").append(1, c);
    else
      quoted += c;
  }
  return quoted + "\"";
}

std::string html(const std::string& raw) {
  std::string text;
  for (const char c : oneLine(raw)) {
    if (c == '<')
      text += "&lt;";
    else if (c == '&')
      text += "&amp;";
    else
      text += c;
  }
  return text;
}

template <class List, class F>
std::string array(const List& list, F&& item) {
  std::string text = "[";
  for (const auto& value : list) {
    if (text.size() > 1) text += ',';
    item(text, value);
  }
  return text + "]";
}

/// NaN becomes null, because JSON has no NaN.
std::string numbers(const std::vector<double>& values, int digits) {
  return array(values, [&](std::string& out, double value) {
    if (std::isfinite(value))
      out += text::generalText(value, digits);
    else
      out += "null";
  });
}

/// Deduplicates x values: curves of one log share their times.
class Axes {
 public:
  std::size_t indexOf(const std::vector<double>& x) {
    const auto same = [&](const std::vector<double>* other) {
      return x.size() == other->size() && std::equal(x.begin(), x.end(), other->begin(), [](double a, double b) {
               return a == b || (std::isnan(a) && std::isnan(b));
             });
    };
    const auto found = std::find_if(axes_.begin(), axes_.end(), same);
    const auto index = static_cast<std::size_t>(found - axes_.begin());
    if (found == axes_.end()) axes_.push_back(&x);
    return index;
  }
  [[nodiscard]] std::string write() const {
    return array(axes_, [](std::string& out, const std::vector<double>* x) { out += numbers(*x, 10); });
  }

 private:
  std::vector<const std::vector<double>*> axes_;
};

std::string curveText(const Curve& curve, Axes& axes) {
  return R"({"label":)" + json(curve.label) + ",\"log\":" + std::to_string(curve.log) +
         ",\"colour\":" + std::to_string(curve.colour) + ",\"dashed\":" + (curve.dashed ? "true" : "false") +
         ",\"marks\":" + (curve.style == Style::kMarks ? "true" : "false") +
         ",\"x\":" + std::to_string(axes.indexOf(curve.x)) + ",\"y\":" + numbers(curve.y, 7) + "}";
}

std::string sourceText(const Source& s) {
  return R"({"label":)" + json(s.label) + ",\"file\":" + json(s.file) + ",\"robot\":" + json(s.robot) +
         ",\"model\":" + json(s.model) + ",\"version\":" + json(s.version) + ",\"date\":" + json(s.date) + "}";
}

std::string figureText(const Figure& figure) {
  Axes axes;
  const std::string panels = array(figure.panels, [&](std::string& out, const Panel& panel) {
    out += "\n{\"title\":" + json(panel.title) + ",\"yLabel\":" + json(panel.y_label) + ",\"curves\":" +
           array(panel.curves, [&](std::string& o, const Curve& curve) { o += "\n" + curveText(curve, axes); }) + "}";
  });
  const auto text = [](std::string& out, const std::string& t) { out += json(t); };
  const auto colour = [](std::string& out, const Colour& c) {
    out += "[" + json(c.on_white) + "," + json(c.on_black) + "]";
  };
  return R"({"title":)" + json(figure.title) + ",\"xLabel\":" + json(figure.x_label) +
         ",\"sources\":" + array(figure.sources, [](std::string& out, const Source& s) { out += sourceText(s); }) +
         ",\"notes\":" + array(figure.notes, text) + ",\"colours\":" + array(kColours, colour) +
         ",\"marks\":" + numbers(figure.marks, 10) + ",\"panels\":" + panels + ",\n\"axes\":" + axes.write() + "}";
}

}  // namespace

std::string htmlPage(const Figure& figure) {
  const std::array<text::TemplatePart, 5> parts{{
      {"@TITLE@", html(figure.title)},
      {"@STYLE@", std::string{page_parts::kLibraryStyle} + std::string{page_parts::kStyle}},
      {"@FIGURE@", figureText(figure)},
      {"@LIBRARY@", std::string{page_parts::kLibrary} + "\n" + std::string{page_parts::kSynchronizer}},
      {"@SCRIPT@", std::string{page_parts::kSamples} + std::string{page_parts::kScript}},
  }};
  return text::filledTemplate(page_parts::kPage, parts);
}

}  // namespace darwinop::plot
