// A P gain that is not what its register says.
#include "twin/servo/effect.hpp"

namespace darwinop::twin {

extern const EffectInfo kKpScale;

namespace {

constexpr std::array kParameters{
    Parameter{.key = "scale",
              .unit = "",
              .meaning = "real gain over register gain",
              .low = 0.2,
              .high = 4,
              .neutral = 1,
              .typical = 1.2,
              .logarithmic = true},
};
constexpr auto kConfusedWith =
    std::to_array<std::string_view>({"resistance_error", "supply_sag", "gear_scale", "deadband"});

class KpScale final : public EffectOf<kKpScale, kParameters.size()> {
 public:
  using EffectOf::EffectOf;
  [[nodiscard]] std::uint8_t hooks() const noexcept override { return kControllerHook; }
  void controller(Signals& s, double /*dt_s*/) noexcept override {
    const auto& [scale] = values_;
    s.p_register *= scale;
  }
};

}  // namespace

const EffectInfo kKpScale{
    .id = "kp_scale",
    .title = "P gain scale error",
    .place = Place::kController,
    .equation = "u = scale K P e",
    .signature = "Stops short by another amount than the model, with the same factor at every load.",
    .separated_by = "The slope of load against error shows it from the log alone, without any mechanics.",
    .source = "Range assumed; benches of this servo family differ from the manual",
    .confused_with = kConfusedWith,
    .parameters = kParameters,
    .make = makeEffect<KpScale>,
};

}  // namespace darwinop::twin
