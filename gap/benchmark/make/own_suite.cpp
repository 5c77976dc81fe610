#include "gap/benchmark/make/own_suite.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <mutex>
#include <sstream>
#include <stdexcept>

#include "gap/benchmark/make/outside.hpp"
#include "gap/benchmark/make/quick.hpp"
#include "gap/case/write_case.hpp"
#include "gap/parallel/parallel.hpp"
#include "twin/effects/catalogue.hpp"

namespace darwinop::gap {
namespace {

constexpr std::array kBaselines{Baseline::kFrictionless, Baseline::kFriction, Baseline::kSpeed, Baseline::kFine};
constexpr std::array kVoltage{Baseline::kFrictionless, Baseline::kFriction, Baseline::kFine};
constexpr std::size_t kEffectFreeCases = 100, kPairCases = 30, kOutsideCases = 20;

bool shows(const twin::EffectInfo& effect, Baseline baseline) {
  const bool speed = baseline == Baseline::kSpeed;
  return effect.laws == twin::Laws::kBoth || (effect.laws == twin::Laws::kReplacesSpeedP) == speed;
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
    // Logs at 16 ms show that it is present, but not which effect it is: one case is enough to test the verdict.
    if (effect->visibility == twin::Visibility::kFirmwareOnly) {
      all.push_back(request(Baseline::kFriction, false, {{.id = id, .severity = 2}}));
      continue;
    }
    for (const Baseline kind : {Baseline::kFrictionless, Baseline::kFriction, Baseline::kSpeed})
      for (const int severity : {1, 2, 3}) {
        const Baseline baseline = kind == Baseline::kFriction && rng.coin() ? Baseline::kFine : kind;
        if (shows(*effect, baseline) && severity <= effect->synthetic.most_severe)
          all.push_back(request(baseline, rng.uniform() < 0.4, {{.id = id, .severity = severity}}));
      }
  }
}

void addEffectFree(std::size_t count, Requests& all) {
  for (std::size_t i = 0; i < count; ++i) all.push_back(request(kBaselines[i / 2 % kBaselines.size()], i % 2 == 1, {}));
}

/// Effects that are plain alone, in the order of their ranks.
std::vector<const twin::EffectInfo*> effectsForPairs() {
  std::vector<const twin::EffectInfo*> effects;
  for (const twin::EffectInfo* const effect : twin::catalogue())
    if (effect->synthetic.pair_rank > 0) effects.push_back(effect);
  std::ranges::stable_sort(effects, {}, [](const auto* effect) { return effect->synthetic.pair_rank; });
  return effects;
}

/// The effect that replaces law speed_p.
std::string otherLaw() {
  const auto all = twin::catalogue();
  return std::string{(*std::ranges::find(all, twin::Laws::kReplacesSpeedP, &twin::EffectInfo::laws))->id};
}

// The logs cannot distinguish doubles, so a pair of them would have no right answer.
bool areDoubles(const twin::EffectInfo& a, const twin::EffectInfo& b) {
  const auto doubles = twin::doublesOf(a);
  return &a == &b || std::ranges::find(doubles, &b) != doubles.end();
}

void addPairs(std::size_t count, Rng& rng, Requests& all) {
  const auto effects = effectsForPairs();
  while (count > 0) {
    const twin::EffectInfo &a = *rng.pick(effects), &b = *rng.pick(effects);
    const Baseline baseline = rng.pick(kBaselines);
    if (areDoubles(a, b) || !shows(a, baseline) || !shows(b, baseline)) continue;
    const bool other_law = baseline == Baseline::kSpeed && rng.uniform() < 0.3;
    const HiddenEffect first{.id = other_law ? otherLaw() : std::string{a.id}, .severity = 3};
    all.push_back(request(baseline, false, {first, {.id = std::string{b.id}, .severity = 2 + (rng.coin() ? 1 : 0)}}));
    --count;
  }
}

void addOutside(std::size_t count, Requests& all) {
  const auto outside = outsideCatalogue();
  for (std::size_t i = 0; i < count; ++i)
    all.push_back(request(kVoltage[i / outside.size() % kVoltage.size()], false,
                          {{.id = std::string{outside[i % outside.size()].id}}}));
}

/// "CV wrong cogging:2"
CaseRequest requestFrom(const std::string& line) {
  std::istringstream words{line};
  CaseRequest out;
  std::string word;
  words >> word;
  out.baseline = *std::ranges::find(kBaselines, word, [](Baseline one) { return nameOf(one); });
  while (words >> word) {
    const std::size_t colon = word.find(':');
    if (word == "wrong")
      out.wrong_numbers = true;
    else if (colon == std::string::npos)
      out.effects.push_back({.id = word});
    else
      out.effects.push_back({.id = word.substr(0, colon), .severity = std::stoi(word.substr(colon + 1))});
  }
  return out;
}

void addQuick(Requests& all) {
  std::istringstream suite{std::string{quick::kSuite}};
  for (std::string line; std::getline(suite, line);)
    if (!line.starts_with('#')) all.push_back(requestFrom(line));
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
  std::mutex key_mutex;
  forEach(requests.size(), [&](std::size_t i) {
    Hidden made = hidden(requests[i]);
    writeCase(made.given, (cases / requests[i].name).string());
    const std::lock_guard lock{key_mutex};
    keys[requests[i].name] = std::move(made.key);
    if (progress) progress(keys.size(), requests.size());
  });
  writeKeys(keys, key.string());
}

}  // namespace darwinop::gap
