// Two models of the whole robot on the held-out recordings of a case. Nothing is fitted.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "gap/identify/body/held_out_gap.hpp"

namespace darwinop::gap {
namespace messages {
inline constexpr const char* kNothingHeldOut =
    ": no held-out recording can be simulated; give one \"role\": \"held_out\", with a clamped trunk best";
}  // namespace messages

/// The noise is that of `after`. Throws std::runtime_error, a sentence, where no recording shows anything.
HeldOutGap compareModels(const BodyCase& given, const twin::Model& before, const twin::Model& after);

/// For a terminal, and for programs.
std::string comparedText(const BodyCase& given, const HeldOutGap& gap);
nlohmann::ordered_json comparedJson(const BodyCase& given, const HeldOutGap& gap);

}  // namespace darwinop::gap
