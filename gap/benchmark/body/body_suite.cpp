#include "gap/benchmark/body/body_suite.hpp"

#include <algorithm>
#include <filesystem>
#include <mutex>
#include <sstream>
#include <stdexcept>

#include "gap/benchmark/body/write_body_case.hpp"
#include "gap/parallel/parallel.hpp"

namespace darwinop::gap {
namespace {

constexpr std::size_t kPairCases = 12, kEffectFreeCases = 16, kOutsideCases = 9;

using BodyRequests = std::vector<BodyRequest>;

std::vector<BodyEffect> ofKind(BodyClass kind) {
  std::vector<BodyEffect> out;
  std::ranges::copy_if(bodyEffects(), std::back_inserter(out), [&](const BodyEffect& one) { return one.kind == kind; });
  return out;
}

void addQuick(Rng& rng, BodyRequests& all) {
  constexpr std::array kKinds{BodyClass::kSensor,  BodyClass::kSensor,  BodyClass::kMass,
                              BodyClass::kContact, BodyClass::kContact, BodyClass::kOneJoint,
                              BodyClass::kPair,    BodyClass::kAll,     BodyClass::kBus};
  for (const BodyClass kind : kKinds) all.push_back({.effects = {rng.pick(ofKind(kind))}});
  all.push_back({.effects = {}});
  all.push_back({.effects = {}, .wrong_numbers = true});
  all.push_back({.effects = {rng.pick(ofKind(BodyClass::kOutside))}});
}

void addSingles(Rng& rng, BodyRequests& all) {
  for (const BodyEffect& effect : bodyEffects())
    if (effect.kind != BodyClass::kOutside) all.push_back({.effects = {effect}, .wrong_numbers = rng.uniform() < 0.25});
}

/// Two effects of different kinds.
void addPairs(Rng& rng, BodyRequests& all) {
  constexpr std::array kKinds{BodyClass::kSensor, BodyClass::kMass, BodyClass::kContact, BodyClass::kOneJoint,
                              BodyClass::kPair};
  for (std::size_t i = 0; i < kPairCases;) {
    const BodyClass a = rng.pick(kKinds), b = rng.pick(kKinds);
    if (a == b) continue;
    all.push_back({.effects = {rng.pick(ofKind(a)), rng.pick(ofKind(b))}});
    ++i;
  }
}

BodyRequests named(BodyRequests all, Rng& rng) {
  for (std::size_t i = 0; i < all.size(); ++i) {
    const std::string number = std::to_string(i + 1);
    all[i].name = "b" + std::string(number.size() < 3 ? 3 - number.size() : 0, '0') + number;
    all[i].seed = rng.next();
  }
  return all;
}

}  // namespace

BodyRequests bodyRequests(std::uint64_t seed, BodyPart part) {
  Rng rng{seed};
  BodyRequests all;
  const auto wanted = [part](BodyPart one) { return part == one || part == BodyPart::kAll; };
  if (part == BodyPart::kQuick) addQuick(rng, all);
  if (wanted(BodyPart::kSingles)) addSingles(rng, all);
  if (wanted(BodyPart::kPairs)) addPairs(rng, all);
  for (std::size_t i = 0; wanted(BodyPart::kEffectFree) && i < kEffectFreeCases; ++i)
    all.push_back({.effects = {}, .wrong_numbers = i % 2 == 1});
  const std::vector<BodyEffect> outside = ofKind(BodyClass::kOutside);
  for (std::size_t i = 0; wanted(BodyPart::kOutside) && i < kOutsideCases; ++i)
    all.push_back({.effects = {outside[i % outside.size()]}});
  rng.shuffle(all);
  return named(std::move(all), rng);
}

BodyRequests bodyRequestsFor(std::uint64_t seed, const std::vector<std::string>& effects) {
  Rng rng{seed};
  BodyRequests all;
  for (const std::string& text : effects) {
    BodyRequest request;
    std::istringstream words{text};
    for (std::string word; std::getline(words, word, ',');) {
      if (word == "wrong")
        request.wrong_numbers = true;
      else if (word != "none")
        request.effects.push_back(bodyEffectCalled(word));
    }
    all.push_back(std::move(request));
  }
  return named(std::move(all), rng);
}

void makeBodyCases(const std::string& folder, const BodyRequests& requests,
                   const std::function<void(std::size_t done, std::size_t of)>& progress) {
  namespace fs = std::filesystem;
  const fs::path cases = fs::path{folder} / "cases", key = fs::path{folder} / "key.json";
  if (fs::exists(cases) || fs::exists(key))
    throw std::runtime_error(folder + " has cases already; give another folder, or remove cases and key.json there");
  BodyKeys keys;
  std::mutex key_mutex;
  forEach(requests.size(), [&](std::size_t i) {
    HiddenBody made = hiddenBody(requests[i]);
    writeBodyCase(made.given, (cases / requests[i].name).string());
    const std::lock_guard lock{key_mutex};
    keys[requests[i].name] = std::move(made.key);
    if (progress) progress(keys.size(), requests.size());
  });
  writeBodyKeys(keys, key.string());
}

}  // namespace darwinop::gap
