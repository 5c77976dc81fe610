#include "gap/report/body/robot_picture.hpp"

#include <algorithm>
#include <array>
#include <vector>

#include "core/joints.hpp"
#include "core/text/formatted.hpp"
#include "core/text/joined.hpp"
#include "gap/report/body/outlines.hpp"
#include "gap/report/html.hpp"

namespace darwinop::gap {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using html::wrap;
using text::formatted;

// All in millimetres of the robot, which are the units of the picture.
constexpr double kUnits = 1000;
constexpr double kWidth = 1130, kBelow = 30;   // of the picture; of it under the floor
constexpr double kFrontX = 430, kSideX = 990;  // middles of the two views
constexpr double kFloorHalf = 120, kFloorThickness = 6;
constexpr double kRadius = 6;                       // of what is inside of the trunk
constexpr double kLabelX = 175, kLabelHeight = 20;  // beside the middle of the front view; of a line
constexpr double kApart = 0.009;                    // m: one of two sensors in the same place would hide the other

const View kFront{.right = {0, 1, 0}, .up = {0, 0, 1}, .towards = {1, 0, 0}};
const View kLeft{.right = {-1, 0, 0}, .up = {0, 0, 1}, .towards = {0, 1, 0}};

struct Body {
  twin::MjModelPtr model;
  twin::MjDataPtr data;
  twin::BodyMap map;
  double lowest = 0, highest = 0;                       // m
  std::map<std::string, Vector3d, std::less<>> inside;  // of the trunk: where they are, m

  explicit Body(const twin::Model& of)
      : model{twin::loadBody(of, false)},
        data{twin::dataFor(*model, of.body.xml)},
        map{twin::mapBody(*model, of.body.xml)} {
    mj_kinematics(model.get(), data.get());
    std::vector<double> heights;
    for (const Outline& outline : outlinesOf(*model, *data, map, kFront))
      for (const Vector2d& corner : outline.corners) heights.push_back(corner.y());
    const auto site = [&](int id) -> Vector3d { return Eigen::Map<const Vector3d>{data->site_xpos + 3 * id}; };
    inside = {{"gyro", site(map.gyro) - kApart * Vector3d::UnitY()},
              {"accelerometer", site(map.accelerometer) + kApart * Vector3d::UnitY()},
              {"battery", Eigen::Map<const Vector3d>{data->xipos + 3 * map.trunk}}};
    if (!heights.empty()) lowest = std::ranges::min(heights), highest = std::ranges::max(heights);
  }
};

/// A view in the picture: `middle` is where its x = 0 is.
class Drawing {
 public:
  Drawing(const Body& body, const View& view, double middle) : body_{body}, view_{view}, middle_{middle} {}

  [[nodiscard]] Vector2d at(const Vector2d& seen) const {
    return {middle_ + kUnits * seen.x(), kUnits * (body_.highest - seen.y())};
  }
  [[nodiscard]] Vector2d at(const Vector3d& point) const { return at(view_.of(point)); }

  [[nodiscard]] std::string links(const PlaceMarks& marks) const {
    std::string out;
    for (const Outline& outline : outlinesOf(*body_.model, *body_.data, body_.map, view_)) {
      std::string corners;
      for (const Vector2d& corner : outline.corners)
        corners += formatted("%s%.0f,%.0f", corners.empty() ? "" : " ", at(corner).x(), at(corner).y());
      out += marked("polygon", "points=\"" + corners + "\"", outline.link, marks);
    }
    return out;
  }
  /// What is marked inside of the trunk, and the floor.
  [[nodiscard]] std::string others(const PlaceMarks& marks) const {
    std::string out;
    for (const auto& [name, place] : body_.inside) {
      if (!marks.contains(name)) continue;
      const Vector2d centre = at(place);
      out += marked("circle", formatted("cx=\"%.0f\" cy=\"%.0f\" r=\"%.0f\"", centre.x(), centre.y(), kRadius), name,
                    marks);
    }
    const Vector2d floor = at(Vector2d{0, body_.lowest});
    return out + marked("rect",
                        formatted("x=\"%.0f\" y=\"%.0f\" width=\"%.0f\" height=\"%.0f\"", middle_ - kFloorHalf,
                                  floor.y(), 2 * kFloorHalf, kFloorThickness),
                        kFloorPlace, marks);
  }
  /// Where a line to the label of a place begins; the middle of the trunk for what is nowhere else.
  [[nodiscard]] Vector2d anchorOf(std::string_view place) const {
    if (place == kFloorPlace) return at(Vector2d{0, body_.lowest}) + Vector2d{kFloorHalf, kFloorThickness / 2};
    if (const auto one = body_.inside.find(place); one != body_.inside.end()) return at(one->second);
    const auto joint = std::ranges::find(kJointTable, place, &JointRow::name);
    const int link = joint == kJointTable.end()
                         ? body_.map.trunk
                         : body_.map.link.at(static_cast<std::size_t>(joint - kJointTable.begin()));
    return at(Vector3d{Eigen::Map<const Vector3d>{body_.data->xipos + 3 * link}});
  }
  [[nodiscard]] double middle() const { return middle_; }

 private:
  static std::string marked(const char* shape, const std::string& attributes, std::string_view place,
                            const PlaceMarks& marks) {
    const auto mark = marks.find(place);
    const PlaceState state = mark == marks.end() ? PlaceState::kUntested : mark->second.state;
    const std::vector<std::string> labels = mark == marks.end() ? std::vector<std::string>{} : mark->second.labels;
    const std::string words = std::string{place} + ": " + std::string{nameOf(state)} + (labels.empty() ? "" : ", ") +
                              text::joined(labels, ", ");
    return wrap(shape, html::element("title", words), " class=\"" + std::string{nameOf(state)} + "\" " + attributes);
  }

  const Body& body_;
  const View& view_;
  double middle_;
};

/// Beside the front view, one below the other, each with a line to its place.
std::string labels(const Drawing& front, const PlaceMarks& marks, double height) {
  struct Label {
    Vector2d from;
    std::string text;
  };
  std::array<std::vector<Label>, 2> columns;  // left, right
  for (const auto& [place, mark] : marks)
    for (const std::string& label : mark.labels) {
      const Vector2d from = front.anchorOf(place);
      columns.at(from.x() < front.middle() ? 0 : 1).push_back({from, place + ": " + label});
    }
  std::string out;
  for (const bool is_right : {false, true}) {
    std::vector<Label>& column = columns.at(is_right ? 1 : 0);
    std::ranges::stable_sort(column, {}, [](const Label& label) { return label.from.y(); });
    double y = 0, left = static_cast<double>(column.size());
    for (const Label& label : column) {
      y = std::max(y + kLabelHeight, std::min(label.from.y(), height - kLabelHeight * left--));
      const double x = front.middle() + (is_right ? kLabelX : -kLabelX);
      out += formatted("<path d=\"M%.0f,%.0f L%.0f,%.0f\"/>", label.from.x(), label.from.y(), x, y) +
             wrap("text", html::text(label.text),
                  formatted(" x=\"%.0f\" y=\"%.0f\" text-anchor=\"%s\"", x, y, is_right ? "start" : "end"));
    }
  }
  return out;
}

}  // namespace

std::string_view nameOf(PlaceState state) {
  constexpr std::array<std::string_view, 5> kNames{"untested", "agrees", "diverges", "possible", "named"};
  return kNames.at(static_cast<std::size_t>(state));
}

std::string robotPicture(const twin::Model& model, const PlaceMarks& marks) {
  const Body body{model};
  if (body.highest <= body.lowest) return "";
  const Drawing front{body, kFront, kFrontX}, side{body, kLeft, kSideX};
  const double height = kUnits * (body.highest - body.lowest) + kBelow;
  return wrap(
      "svg",
      front.links(marks) + front.others(marks) + side.links(marks) + side.others(marks) + labels(front, marks, height),
      formatted(" viewBox=\"0 0 %.0f %.0f\" role=\"img\" aria-label=\"The robot from the front and from its left\"",
                kWidth, height));
}

}  // namespace darwinop::gap
