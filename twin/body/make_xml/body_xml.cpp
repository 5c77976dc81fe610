// Writes the MuJoCo body file: the fixed world, then one element per table row.
#include "twin/body/make_xml/body_xml.hpp"

#include <cmath>
#include <sstream>
#include <stdexcept>
#include <vector>

#include "core/servo_limits.hpp"
#include "core/text/number_text.hpp"
#include "core/units.hpp"
#include "twin/body/make_xml/csv.hpp"
#include "twin/body/make_xml/world_xml.hpp"

namespace darwinop::twin {
namespace {

// Height of the trunk origin above the floor, standing straight: hip 122.2 mm, leg 219.5 mm, clearance 0.3 mm.
constexpr double kStartHeight = 0.342;
// Horizontal field of view of the head camera (2013 model), rad, aspect 4:3. MuJoCo uses the vertical one.
constexpr double kFieldOfView = 1.0123;

// Axes of the board's sensors in the trunk (docs/twin/body.md): accelerometer right, forward, up; gyro backward,
// right, up. The camera looks along the head's z; MuJoCo's cameras look along their own -z.
constexpr std::string_view kTrunkSites =
    R"(<site name="accelerometer" pos="0 -0.0684064 -0.01" xyaxes="-1 0 0 0 0 1" size="0.004"/>
<site name="gyro" pos="0 -0.0684064 0.01" xyaxes="0 0 -1 -1 0 0" size="0.004"/>
)";

std::string brief(double value) {
  return text::generalText(value, 9);
}

std::string triple(const Csv& csv, std::size_t row, const std::string& a, const std::string& b, const std::string& c) {
  return csv.text(row, a) + ' ' + csv.text(row, b) + ' ' + csv.text(row, c);
}

struct Tables {
  Csv joints, links, collision, visual;
};

std::string shapeOf(const Csv& csv, std::size_t row) {
  const std::string& shape = csv.text(row, "shape");
  const auto half = [&](const char* column) { return brief(csv.number(row, column) / 2); };
  std::string out = "type=\"" + shape + "\" size=\"";
  const bool round = shape == "capsule" || shape == "cylinder";
  if (shape == "box" || shape == "ellipsoid")
    out += half("sx_or_height") + ' ' + half("sy_or_radius") + ' ' + half("sz");
  else if (round)
    out += csv.text(row, "sy_or_radius") + ' ' + half("sx_or_height");
  else if (shape == "sphere")
    out += half("sx_or_height");
  else
    throw std::runtime_error{"row " + std::to_string(row + 2) + ": shape \"" + shape +
                             "\"; known are box, capsule, cylinder, ellipsoid, sphere"};
  out += "\" pos=\"" + triple(csv, row, "tx", "ty", "tz") + '"';
  const double angle = csv.number(row, "angle");
  if (round) {
    // Cylinder axis: y in the tables, z in MuJoCo. Rotate by 90 degrees about x first (z to -y), then as in the table.
    const double half_angle = angle / 2, n = std::sqrt(0.5);
    const double rx = csv.number(row, "rx") * std::sin(half_angle), ry = csv.number(row, "ry") * std::sin(half_angle);
    const double rz = csv.number(row, "rz") * std::sin(half_angle), w = std::cos(half_angle);
    out += " quat=\"" + brief(n * (w - rx)) + ' ' + brief(n * (w + rx)) + ' ' + brief(n * (ry + rz)) + ' ' +
           brief(n * (rz - ry)) + '"';
  } else if (angle != 0) {
    out += " axisangle=\"" + triple(csv, row, "rx", "ry", "rz") + ' ' + csv.text(row, "angle") + '"';
  }
  return out;
}

class Writer {
 public:
  explicit Writer(Tables tables) : t_{std::move(tables)} {}

  std::string write() {
    out_ << kWorld;
    depth_ = 2;
    line("<body name=\"Body\" pos=\"0 0 " + brief(kStartHeight) + "\" quat=\"0.5 0.5 0.5 0.5\">");
    ++depth_;
    line("<freejoint name=\"Body\"/>");
    link("Body");
    --depth_;
    line("</body>");
    out_ << "  </worldbody>\n  <tendon>\n";
    for (std::size_t row = 0; row < t_.joints.rows(); ++row) {
      const std::string& name = t_.joints.text(row, "name");
      out_ << "    <fixed name=\"" << name << "\"><joint joint=\"" << name << "\" coef=\"1\"/></fixed>\n";
    }
    out_ << "  </tendon>\n  <contact>\n"
         << "    <pair geom1=\"floor\" geom2=\"ball\" condim=\"6\" friction=\"0.8 0.8 0.001 0.0008 0.0008\"/>\n";
    for (const std::string& shape : shapes_)
      for (const char* other : {"floor", "ball"})
        out_ << "    <pair geom1=\"" << other << "\" geom2=\"" << shape << "\"/>\n";
    out_ << "  </contact>\n</mujoco>\n";
    return out_.str();
  }

 private:
  void line(std::string_view text) { out_ << std::string(2 * depth_, ' ') << text << '\n'; }

  // Inertia, geoms, sites and camera of a link, then its children.
  void link(const std::string& name) {
    inertia(name);
    if (name == "Body") {
      std::istringstream sites{std::string{kTrunkSites}};
      for (std::string text; std::getline(sites, text);) line(text);
    }
    if (name == "Head") {
      const double vertical = 2 * std::atan(std::tan(kFieldOfView / 2) * 3 / 4) / kRadPerDegree;
      line("<camera name=\"head\" pos=\"0 0.0329074 0.0359816\" xyaxes=\"-1 0 0 0 1 0\" fovy=\"" + brief(vertical) +
           "\"/>");
    }
    shapes(t_.collision, name, "collision");
    shapes(t_.visual, name, "visual");
    for (std::size_t row = 0; row < t_.joints.rows(); ++row)
      if (t_.joints.text(row, "parent") == name) child(row);
  }

  void child(std::size_t row) {
    const Csv& joints = t_.joints;
    const std::string axis = triple(joints, row, "axis_x", "axis_y", "axis_z");
    std::string open =
        "<body name=\"" + joints.text(row, "child") + "\" pos=\"" + triple(joints, row, "tx", "ty", "tz") + '"';
    if (joints.number(row, "zero_angle_about_axis") != 0)
      open += " axisangle=\"" + axis + ' ' + joints.text(row, "zero_angle_about_axis") + '"';
    line(open + '>');
    ++depth_;
    const auto [low, high] = range(row);
    line("<joint name=\"" + joints.text(row, "name") + "\" axis=\"" + axis + "\" range=\"" + low + ' ' + high + "\"/>");
    link(joints.text(row, "child"));
    --depth_;
    line("</body>");
  }

  // Union of the model's and the servo's range, so that goals at both limits are reachable.
  [[nodiscard]] std::pair<std::string, std::string> range(std::size_t row) const {
    const auto rad = [](double tick) { return (tick - kTickCentre) * kRadPerTick; };
    const double low = rad(t_.joints.number(row, "tick_min")), high = rad(t_.joints.number(row, "tick_max"));
    return {low < t_.joints.number(row, "min_rad") ? brief(low) : t_.joints.text(row, "min_rad"),
            high > t_.joints.number(row, "max_rad") ? brief(high) : t_.joints.text(row, "max_rad")};
  }

  void inertia(const std::string& name) {
    const Csv& links = t_.links;
    for (std::size_t row = 0; row < links.rows(); ++row)
      if (links.text(row, "link") == name)
        line("<inertial pos=\"" + triple(links, row, "com_x", "com_y", "com_z") + "\" mass=\"" +
             links.text(row, "mass_kg") + "\" fullinertia=\"" + triple(links, row, "I11", "I22", "I33") + ' ' +
             triple(links, row, "I12", "I13", "I23") + "\"/>");
  }

  void shapes(const Csv& csv, const std::string& name, const std::string& kind) {
    int count = 0;
    for (std::size_t row = 0; row < csv.rows(); ++row) {
      if (csv.text(row, "link") != name) continue;
      std::string text = "<geom class=\"" + kind + "\" ";
      if (kind == "collision") {
        shapes_.push_back(name + '_' + std::to_string(++count));
        text += "name=\"" + shapes_.back() + "\" ";
      } else if (!csv.text(row, "name").empty()) {
        text += "name=\"" + csv.text(row, "name") + "\" ";
      }
      text += shapeOf(csv, row);
      if (kind == "visual") text += " material=\"" + csv.text(row, "material") + '"';
      line(text + "/>");
    }
  }

  Tables t_;
  std::ostringstream out_;
  std::vector<std::string> shapes_;  // names of collision geoms
  std::size_t depth_ = 0;
};

}  // namespace

std::string bodyXml(const std::string& data) {
  return Writer{{Csv{data + "/model_joints.csv"}, Csv{data + "/model_links.csv"}, Csv{data + "/model_collision.csv"},
                 Csv{data + "/model_visual.csv"}}}
      .write();
}

}  // namespace darwinop::twin
