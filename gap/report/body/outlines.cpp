#include "gap/report/body/outlines.hpp"

#include <algorithm>
#include <cmath>

#include "core/joints.hpp"
#include "core/units.hpp"

namespace darwinop::gap {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr int kDrawnGroup = 1;                  // class "visual" of the body file
constexpr int kMeridians = 16, kParallels = 4;  // a polygon of 16 corners is round at a width of 300 pixels

/// Directions over a sphere.
std::vector<Vector3d> directions() {
  std::vector<Vector3d> out;
  for (int parallel = -kParallels; parallel <= kParallels; ++parallel)
    for (int meridian = 0; meridian < kMeridians; ++meridian) {
      const double latitude = parallel * kPi / 2 / kParallels, longitude = 2 * kPi * meridian / kMeridians;
      out.emplace_back(std::cos(latitude) * std::cos(longitude), std::cos(latitude) * std::sin(longitude),
                       std::sin(latitude));
    }
  return out;
}

/// Points of the geom's own frame whose convex hull it is; none: a type that is not drawn.
std::vector<Vector3d> pointsOf(int type, const Vector3d& size) {
  static const std::vector<Vector3d> kDirections = directions();
  std::vector<Vector3d> out;
  for (const Vector3d& direction : kDirections) {
    if (type == mjGEOM_SPHERE) out.emplace_back(size[0] * direction);
    if (type == mjGEOM_ELLIPSOID) out.emplace_back(size.cwiseProduct(direction));
    if (type == mjGEOM_BOX) out.emplace_back(size.cwiseProduct(direction.cwiseSign()));
    for (const double end : {-size[1], size[1]}) {
      const Vector2d rim = direction.head<2>().normalized() * size[0];
      if (type == mjGEOM_CAPSULE) out.emplace_back(size[0] * direction + Vector3d{0, 0, end});
      if (type == mjGEOM_CYLINDER) out.emplace_back(rim[0], rim[1], end);
    }
  }
  return out;
}

double cross(const Vector2d& from, const Vector2d& a, const Vector2d& b) {
  return (a - from).x() * (b - from).y() - (a - from).y() * (b - from).x();
}

/// Convex hull by monotone chains, anticlockwise.
std::vector<Vector2d> hullOf(std::vector<Vector2d> points) {
  std::ranges::sort(points, [](const Vector2d& a, const Vector2d& b) {
    return std::pair{a.x(), a.y()} < std::pair{b.x(), b.y()};
  });
  std::vector<Vector2d> hull;
  const auto addChain = [&](auto begin, auto end) {
    const std::size_t first = hull.size();
    for (auto point = begin; point != end; ++point) {
      while (hull.size() >= first + 2 && cross(hull[hull.size() - 2], hull.back(), *point) <= 0) hull.pop_back();
      hull.push_back(*point);
    }
    hull.pop_back();  // begins the other chain
  };
  addChain(points.begin(), points.end());
  addChain(points.rbegin(), points.rend());
  return hull;
}

/// The link that this body is fixed to; empty: it is not of the robot.
std::string linkOf(const mjModel& m, const twin::BodyMap& map, int body) {
  for (; body > 0; body = m.body_parentid[body]) {
    if (body == map.trunk) return "Body";
    const auto link = std::ranges::find(map.link, body);
    if (link != map.link.end()) return std::string{kJointTable[static_cast<std::size_t>(link - map.link.begin())].name};
  }
  return "";
}

}  // namespace

std::vector<Outline> outlinesOf(const mjModel& m, const mjData& d, const twin::BodyMap& map, const View& view) {
  std::vector<Outline> out;
  for (int geom = 0; geom < m.ngeom; ++geom) {
    const std::string link = linkOf(m, map, m.geom_bodyid[geom]);
    if (m.geom_group[geom] != kDrawnGroup || link.empty()) continue;
    const Eigen::Map<const Vector3d> size{m.geom_size + 3 * geom}, centre{d.geom_xpos + 3 * geom};
    const Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>> axes{d.geom_xmat + 9 * geom};
    std::vector<Vector2d> seen;
    for (const Vector3d& point : pointsOf(m.geom_type[geom], size)) seen.push_back(view.of(centre + axes * point));
    if (seen.empty()) continue;
    out.push_back({.link = link, .corners = hullOf(std::move(seen)), .depth = view.towards.dot(centre)});
  }
  std::ranges::stable_sort(out, {}, &Outline::depth);
  return out;
}

}  // namespace darwinop::gap
