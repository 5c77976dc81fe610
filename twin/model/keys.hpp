// The table of all keys of a model file but those of effects (the catalogue has these). Reader, writer, messages and
// docs/twin/models.md are made from it.
#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <variant>

#include "twin/model/model.hpp"
#include "twin/model/number.hpp"

namespace darwinop::twin {

/// Where in a Model a value lies; its type says how it is written.
using Slot = std::variant<double*, std::array<double, 3>*, bool*, Law*, TrunkCom*, TrunkInertia*, std::string*>;

struct KeyRow {
  std::string_view section, key;
  Slot (*in)(Model&);
  NumberRule number;                        // of numbers
  std::span<const std::string_view> words;  // of enumerations, in the order of their values; no and yes
  std::string_view meaning;
};

std::span<const KeyRow> keyTable();
/// "model", "servo", "body", "imu".
std::span<const std::string_view> plainSections();
/// Null: there is no such key. Both in lower case.
const KeyRow* findKey(std::string_view section, std::string_view key);
std::vector<std::string_view> keysOf(std::string_view section);

/// Of an effect's parameter.
NumberRule ruleOf(const Parameter& parameter);

/// Sets the value from its text. Throws std::runtime_error, a sentence that says what is allowed.
void readValue(Model& model, const KeyRow& row, std::string_view text);
std::string writeValue(const Model& model, const KeyRow& row);

/// For people: "0.1 to 10 N m/A", "voltage_p or speed_p".
std::string allowed(const KeyRow& row);
/// All keys with their defaults in Markdown, one list per section.
std::string keysAsMarkdown();

}  // namespace darwinop::twin
