#include "gap/benchmark/make/own_suite.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <mutex>
#include <stdexcept>

#include "gap/benchmark/make/outside.hpp"
#include "gap/case/write_case.hpp"
#include "gap/parallel/parallel.hpp"
#include "twin/effects/catalogue.hpp"

namespace darwinop::gap {
namespace {

constexpr std::array kBaselines{Baseline::kFrictionless, Baseline::kFriction, Baseline::kSpeed, Baseline::kFine};
constexpr std::array kVoltage{Baseline::kFrictionless, Baseline::kFriction, Baseline::kFine};
constexpr std::size_t kEffectFreeCases = 100, kPairCases = 30, kOutsideCases = 20;

template <class List>
bool isIn(const List& list, std::string_view id) {
  return std::ranges::find(list, id) != list.end();
}

// A motor that takes any speed at once has neither a duty nor a winding.
constexpr auto kOfTheDuty =
    std::to_array<std::string_view>({"supply_sag", "kt_error", "resistance_error", "integral", "derivative"});
// A host at 16 ms can see that they are there, not what they are: one case each is enough to see what is said of them.
constexpr auto kOfTheFirmware = std::to_array<std::string_view>({"lost_packets", "encoder_quantisation"});

// All of its plausible range is within the noise: asked for once a baseline.
constexpr std::string_view kNeverPlain = "quadratic_load_friction";

bool shows(std::string_view effect, Baseline baseline) {
  const bool speed = baseline == Baseline::kSpeed;
  return effect == "p_on_torque" ? speed : !(speed && isIn(kOfTheDuty, effect));
}

CaseRequest request(Baseline baseline, bool wrong_numbers, std::vector<HiddenEffect> effects) {
  CaseRequest out;
  out.baseline = baseline;
  out.wrong_numbers = wrong_numbers;
  out.effects = std::move(effects);
  return out;
}

using Requests = std::vector<CaseRequest>;

void addSingles(Rng& rng, Requests& all) {
  for (const twin::EffectInfo* const effect : twin::catalogue()) {
    const std::string id{effect->id};
    if (isIn(kOfTheFirmware, id)) {
      all.push_back(request(Baseline::kFriction, false, {{.id = id, .severity = 2}}));
      continue;
    }
    for (const Baseline kind : {Baseline::kFrictionless, Baseline::kFriction, Baseline::kSpeed})
      for (const int severity : {1, 2, 3}) {
        const Baseline baseline = kind == Baseline::kFriction && rng.coin() ? Baseline::kFine : kind;
        if (shows(id, baseline) && (severity == 1 || id != kNeverPlain))
          all.push_back(request(baseline, rng.uniform() < 0.4, {{.id = id, .severity = severity}}));
      }
  }
}

void addEffectFree(std::size_t count, Requests& all) {
  for (std::size_t i = 0; i < count; ++i) all.push_back(request(kBaselines[i / 2 % kBaselines.size()], i % 2 == 1, {}));
}

// Effects that are plain alone and act in different places; doubles of each other would be a riddle without an answer.
constexpr auto kForPairs = std::to_array<std::string_view>(
    {"accel_limit", "speed_limit", "torque_limit", "coulomb", "viscous", "stribeck", "load_dependent_friction",
     "backlash", "deadband", "transport_delay", "encoder_offset", "gear_scale", "cogging", "joint_flex", "com_mass",
     "supply_sag", "kp_scale"});

bool areDoubles(std::string_view a, std::string_view b) {
  const auto doubles = twin::doublesOf(*twin::findEffect(a));
  return a == b || std::ranges::any_of(doubles, [&](const twin::EffectInfo* other) { return other->id == b; });
}

void addPairs(std::size_t count, Rng& rng, Requests& all) {
  while (count > 0) {
    const std::string_view a = rng.pick(kForPairs), b = rng.pick(kForPairs);
    const Baseline baseline = rng.pick(kBaselines);
    if (areDoubles(a, b) || !shows(a, baseline) || !shows(b, baseline)) continue;
    const bool other_law = baseline == Baseline::kSpeed && rng.uniform() < 0.3;
    const HiddenEffect first{.id = other_law ? "p_on_torque" : std::string{a}, .severity = 3};
    all.push_back(request(baseline, false, {first, {.id = std::string{b}, .severity = 2 + (rng.coin() ? 1 : 0)}}));
    --count;
  }
}

void addOutside(std::size_t count, Requests& all) {
  const auto strangers = outsideCatalogue();
  for (std::size_t i = 0; i < count; ++i)
    all.push_back(request(kVoltage[i / strangers.size() % kVoltage.size()], false,
                          {{.id = std::string{strangers[i % strangers.size()].id}}}));
}

// One of each kind of verdict, and the effects that are met most often.
void addQuick(Requests& all) {
  const auto single = [](Baseline baseline, bool wrong, const char* id, int severity) {
    return request(baseline, wrong, {{.id = id, .severity = severity}});
  };
  all = {single(Baseline::kFriction, false, "coulomb", 2),         single(Baseline::kFrictionless, false, "viscous", 2),
         single(Baseline::kFriction, false, "transport_delay", 2), single(Baseline::kFriction, true, "cogging", 2),
         single(Baseline::kSpeed, false, "accel_limit", 2),        single(Baseline::kSpeed, false, "p_on_torque", 3),
         single(Baseline::kFrictionless, false, "deadband", 3)};
  addEffectFree(2, all);
  all.push_back(request(Baseline::kSpeed, true, {}));
  all.push_back(request(Baseline::kFrictionless, false,
                        {{.id = "coulomb", .severity = 2}, {.id = "transport_delay", .severity = 3}}));
  all.push_back(request(Baseline::kFriction, false, {{.id = "u_cable"}}));
}

}  // namespace

std::vector<CaseRequest> ownRequests(std::uint64_t seed, Part part) {
  Rng rng{seed};
  Requests all;
  const auto wanted = [part](Part one) { return part == one || part == Part::kAll; };
  if (part == Part::kQuick) addQuick(all);
  if (wanted(Part::kSingles)) addSingles(rng, all);
  if (wanted(Part::kEffectFree)) addEffectFree(kEffectFreeCases, all);
  if (wanted(Part::kPairs)) addPairs(kPairCases, rng, all);
  if (wanted(Part::kOutside)) addOutside(kOutsideCases, all);
  rng.shuffle(all);
  for (std::size_t i = 0; i < all.size(); ++i) {
    const std::string number = std::to_string(i + 1);
    all[i].name = "c" + std::string(number.size() < 3 ? 3 - number.size() : 0, '0') + number;
    all[i].seed = rng.next();
  }
  return all;
}

void makeCases(const std::string& folder, const std::vector<CaseRequest>& requests, const Progress& progress) {
  namespace fs = std::filesystem;
  const fs::path cases = fs::path{folder} / "cases", key = fs::path{folder} / "key.json";
  if (fs::exists(cases) || fs::exists(key))
    throw std::runtime_error(folder + " has cases already; give another folder, or remove cases and key.json there");
  Keys keys;
  std::mutex noting;
  forEach(requests.size(), [&](std::size_t i) {
    Hidden made = hidden(requests[i]);
    writeCase(made.given, (cases / requests[i].name).string());
    const std::lock_guard lock{noting};
    keys[requests[i].name] = std::move(made.key);
    if (progress) progress(keys.size(), requests.size());
  });
  writeKeys(keys, key.string());
}

void makeSuite(const std::string& folder, std::uint64_t seed, Part part, const Progress& progress) {
  makeCases(folder, ownRequests(seed, part), progress);
}

}  // namespace darwinop::gap
