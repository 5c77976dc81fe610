#include "gap/benchmark/body/soft_contacts.hpp"

namespace darwinop::gap {
namespace {

using MapR = Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>;

}  // namespace

SoftContacts::SoftContacts(const mjModel& m, const twin::BodyMap& map) {
  for (int pair = 0; pair < m.npair; ++pair) {
    const int a = m.pair_geom1[pair], b = m.pair_geom2[pair];
    if (a != map.floor && b != map.floor) continue;
    const int geom = a == map.floor ? b : a;
    const mjtNum* const size = m.geom_size + 3 * geom;
    if (m.geom_type[geom] == mjGEOM_BOX)
      for (unsigned corner = 0; corner < 8; ++corner)
        feelers_.push_back({geom,
                            m.geom_bodyid[geom],
                            {(corner & 1U) != 0 ? size[0] : -size[0], (corner & 2U) != 0 ? size[1] : -size[1],
                             (corner & 4U) != 0 ? size[2] : -size[2]},
                            0});
    if (m.geom_type[geom] == mjGEOM_CAPSULE)
      for (const double end : {-size[1], size[1]})
        feelers_.push_back({geom, m.geom_bodyid[geom], {0, 0, end}, size[0]});
  }
}

void SoftContacts::addTo(std::vector<SoftRow>& rows, const mjModel& m, const mjData& d, int first,
                         const ContactNumbers& numbers) {
  touching_.clear();
  const double stiffness = numbers.stiffness_n_m, damping = numbers.damping_ns_m;
  Eigen::Matrix<double, 3, Eigen::Dynamic, Eigen::RowMajor> jacobian(3, m.nv);
  for (std::size_t k = 0; k < feelers_.size(); ++k) {
    Feeler& feeler = feelers_[k];
    const MapR turn{d.geom_xmat + 9 * feeler.geom};
    const Eigen::Vector3d point = Eigen::Map<const Eigen::Vector3d>{d.geom_xpos + 3 * feeler.geom} + turn * feeler.at;
    const double height = point.z() - feeler.radius;
    if (height > 0) {
      feeler.touched = false;
      continue;
    }
    if (!feeler.touched) feeler.anchor.setZero();
    feeler.touched = true;
    const Eigen::Vector3d at = point - feeler.radius * Eigen::Vector3d::UnitZ();
    mj_jac(&m, &d, jacobian.data(), nullptr, at.data(), feeler.body);
    const int normal = static_cast<int>(rows.size());
    const auto direction = [&](Eigen::Index axis) -> Eigen::VectorXd {
      return jacobian.row(axis).tail(m.nv - first).transpose();
    };
    rows.push_back(
        {.direction = direction(2), .stiffness = stiffness, .damping = damping, .bend = height, .only_pushes = true});
    for (Eigen::Index axis = 0; axis < 2; ++axis)
      rows.push_back({.direction = direction(axis),
                      .stiffness = stiffness,
                      .damping = damping,
                      .bend = feeler.anchor[axis],
                      .limit = numbers.friction,
                      .normal = normal});
    touching_.push_back(k);
  }
}

void SoftContacts::keepBends(const std::vector<SoftRow>& rows) {
  std::size_t at = rows.size() - 3 * touching_.size();
  for (const std::size_t k : touching_) {
    feelers_[k].anchor = {rows[at + 1].bend_new, rows[at + 2].bend_new};
    at += 3;
  }
}

}  // namespace darwinop::gap
