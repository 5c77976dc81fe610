// Sets centre of mass and inertia of the trunk. Sources and reasons: docs/twin/body.md, "What is doubtful".
#include "twin/body/trunk.hpp"

#include <algorithm>

namespace darwinop::twin {
namespace {

// Manufacturer's drawing, and the model of 2011.
constexpr std::array<double, 3> kManufacturer{-0.00311589, -0.0394437, -0.0196631};
// Every published model since October 2012: moved down and back, for more stability.
constexpr std::array<double, 3> kWebots2013{0, -0.08, -0.05};
// Uniform box of the trunk's size, m: left, up, forward.
constexpr std::array<double, 3> kBox{0.114, 0.122, 0.112};
// Published inertia about the centre of mass, kg m2: 11, 22, 33, 12, 13, 23.
constexpr std::array<double, 6> kPublished{3108.18000e-6, 6378.77760e-6, 5331.64250e-6,
                                           -254.60189e-6, 2031.81740e-6, 164.17863e-6};

}  // namespace

std::array<double, 3> trunkCom(TrunkCom choice) {
  switch (choice) {
    case TrunkCom::kManufacturer:
      return kManufacturer;
    case TrunkCom::kWebots2013:
      return kWebots2013;
    case TrunkCom::kHalfway:
      break;
  }
  std::array<double, 3> halfway{};
  for (std::size_t i = 0; i < 3; ++i) halfway[i] = (kManufacturer[i] + kWebots2013[i]) / 2;
  return halfway;
}

void setTrunk(mjModel& m, int trunk, const BodySettings& settings) {
  std::ranges::copy(trunkCom(settings.trunk_com), m.body_ipos + 3 * trunk);
  mjtNum* moments = m.body_inertia + 3 * trunk;
  mjtNum* axes = m.body_iquat + 4 * trunk;
  if (settings.trunk_inertia == TrunkInertia::kBox) {
    const double twelfth = m.body_mass[trunk] / 12;
    const auto squared = [](std::size_t i) { return kBox[i] * kBox[i]; };
    moments[0] = twelfth * (squared(1) + squared(2));
    moments[1] = twelfth * (squared(0) + squared(2));
    moments[2] = twelfth * (squared(0) + squared(1));
    std::ranges::copy(std::array<double, 4>{1, 0, 0, 0}, axes);
    return;
  }
  const auto& [xx, yy, zz, xy, xz, yz] = kPublished;
  const std::array<mjtNum, 9> matrix{xx, xy, xz, xy, yy, yz, xz, yz, zz};
  std::array<mjtNum, 9> vectors{};
  mju_eig3(moments, vectors.data(), axes, matrix.data());
}

}  // namespace darwinop::twin
