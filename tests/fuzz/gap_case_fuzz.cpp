// case.json: an error message, or a valid case that is written without loss.
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <string_view>

#include "experiments/logs/read_log.hpp"
#include "gap/case/data_check.hpp"
#include "gap/case/parse_case.hpp"
#include "gap/case/write_case.hpp"

namespace {

using namespace darwinop;

void require(bool holds) {
  if (!holds) std::abort();
}

/// 2.1 s of a slow motion; any file that a case names.
logs::Log anyLog(const std::string& name) {
  std::string text = "t_s,goal_rad,torque_on,pos_rad,load_pct\n";
  for (int i = 0; i < 60; ++i)
    text += std::to_string(0.035 * i) + ",0.1,1," + std::to_string(0.0015 * (i % 30)) + ",5\n";
  return logs::parseLog(text, name);
}

twin::Model anyModel(const std::string&) {
  return twin::parseModel(
      "[model]\nname = any\n[effect coulomb]\nfriction = 0.1 N m\n[effect coulomb Neck]\n"
      "friction = 0.2 N m\n",
      "any.ini");
}

void requireSane(const gap::Case& c) {
  require(!c.logs.empty() && !c.name.empty());
  for (const twin::EffectSetting& effect : c.model.effects) {
    require(!effect.joint && effect.values.size() == effect.info->parameters.size());
    for (const double value : effect.values) require(std::isfinite(value));
  }
  for (const gap::Prior& prior : c.priors) require(prior.relative_sigma > 0 && prior.relative_sigma <= 10);
  require(c.pendulum.length_m > 0 && c.pendulum.arm_mass_kg >= 0);
  for (const gap::Trajectory& log : c.logs) {
    require(log.rows() > 1 && log.position_rad.size() == log.rows() && log.temp_c.size() == log.rows());
    require(!log.repeat_of || *log.repeat_of < c.logs.size());
    require(log.payload_kg >= 0 && log.p_register >= 0);
  }
  require(!asText(checkData(c)).empty());
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const gap::CaseFiles files{.log = anyLog, .model = anyModel};
  gap::Case c;
  try {
    c = gap::parseCase({reinterpret_cast<const char*>(data), size}, "my/case.json", files);
  } catch (const gap::BadInput& refused) {
    require(std::string_view{refused.what()}.find(": ") != std::string_view::npos);
    return 0;
  }
  requireSane(c);
  const bool plain = gap::fitsBaseline(c);
  const auto own = [&](const std::string&) { return c.model; };
  const std::string written = gap::caseAsJson(c, !plain);
  const gap::Case back = gap::parseCase(written, "my/case.json", {.log = anyLog, .model = own});
  require(gap::caseAsJson(back, !plain) == written);
  return 0;
}
