#include "gap/benchmark/body/thesis_suite.hpp"

namespace darwinop::gap {
namespace {

using Given = std::vector<BodyKeyEffect>;

/// 5.2: x and z mirrored about 512.
const Given kMirroredAccelerometer{{"accel_axes", {"accelerometer"}, {{"map", {-1, 2, -3}}}}};

/// 5.2.1: the simulator's trunk was 20 mm too low and 15 mm too far back (half of the shift of 2012, which 5.5 takes
/// back), and its soles were 25 % too large.
const Given kBowTest{{"link_com", {"Body"}, {{"shift", {-0.0015, 0.0203, 0.0151}}}},
                     {"sole_size", {"floor"}, {{"scale", {0.8}}}}};

/// 5.4 and appendix G: what was tried one by one, and what else a gyroscope can have. 1.147: the simulator's counts for
/// the robot's. Soles of half the area: on a quarter the robot falls.
const std::vector<Given> kWalk{{{"accel_axes", {"accelerometer"}, {{"map", {-1, 2, 3}}}}},
                               {{"contact_time", {"floor"}, {{"time", {0.03}}}}},
                               {{"link_mass", {"Body"}, {{"mass", {0.3}}}}},
                               {{"link_com", {"Body"}, {{"shift", {0, 0.02, 0}}}}},
                               {{"sole_size", {"floor"}, {{"scale", {0.7}}}}},
                               {{"transport_delay", {"all"}, {{"delay", {0.012}}}}},
                               {{"kp_scale", {"all"}, {{"scale", {0.8}}}}},
                               {{"encoder_offset", {"AnkleR"}, {{"offset", {0.03}}}}},
                               {{"gyro_scale", {"gyro"}, {{"scale", {1.147, 1.147, 1.147}}}}},
                               {{"gyro_axes", {"gyro"}, {{"map", {1, -2, 3}}}}},
                               {{"gyro_lowpass", {"gyro"}, {{"time", {0.03}}}}},
                               {{"imu_delay", {"imu"}, {{"delay", {0.024}}}}},
                               {}};

}  // namespace

std::vector<BodyRequest> thesisRequests(std::uint64_t seed) {
  Rng rng{seed};
  std::vector<BodyRequest> all;
  const auto add = [&](const std::string& name, const Given& given, FloorMotions on_floor = FloorMotions::kWalks) {
    all.push_back({.name = name, .seed = rng.next(), .given = given, .on_floor = on_floor});
  };
  add("t5", kMirroredAccelerometer);
  add("t6", kBowTest, FloorMotions::kBows);
  for (std::size_t i = 0; i < kWalk.size(); ++i) add("t9" + std::string(1, static_cast<char>('a' + i)), kWalk[i]);
  return all;
}

}  // namespace darwinop::gap
