// Table of the keys of a model file, except those of effects (see the catalogue). Reader, writer, messages and
// docs/twin/models.md are generated from it.
#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <variant>

#include "twin/model/model.hpp"
#include "twin/model/number.hpp"

namespace darwinop::twin {

/// Pointer to the value in a Model; its type selects the text format.
using Slot = std::variant<double*, std::array<double, 3>*, bool*, Law*, TrunkCom*, TrunkInertia*, std::string*>;

/// Where a model has the value of a key.
struct SlotOf {
  Slot (*of)(Model&, std::size_t link);
  std::size_t link = 0;

  constexpr SlotOf(Slot (*function)(Model&, std::size_t)) : of{function} {}
  Slot operator()(Model& model) const { return of(model, link); }
};

struct KeyRow {
  std::string_view section, key;
  SlotOf in;
  NumberRule number;                        // if the value is a number
  std::span<const std::string_view> words;  // if the value is an enumeration (in the order of its values) or bool
  std::string_view meaning;
};

/// Rows of the plain sections, then those of each link.
std::span<const KeyRow> keyTable();
/// "model", "servo", "body", "imu".
std::span<const std::string_view> plainSections();
inline constexpr std::string_view kLinkSection = "link";
/// "link ArmLowerR"
std::string_view linkSection(std::size_t link);
/// Null if there is no such key. `section` as in plainSections() or of linkSection(), `key` in lower case.
const KeyRow* findKey(std::string_view section, std::string_view key);
std::vector<std::string_view> keysOf(std::string_view section);

/// Unit and range of an effect parameter.
NumberRule ruleOf(const Parameter& parameter);

/// Sets the value from its text. Throws std::runtime_error with the allowed range.
void readValue(Model& model, const KeyRow& row, std::string_view text);
std::string writeValue(const Model& model, const KeyRow& row);

/// Allowed values for messages: "0.1 to 10 N m/A", "voltage_p or speed_p".
std::string allowed(const KeyRow& row);
/// All keys with their defaults as Markdown, one list per section.
std::string keysAsMarkdown();

}  // namespace darwinop::twin
