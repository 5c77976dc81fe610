// The body file of a model whose text is written into another folder.
#pragma once

#include <cstdint>
#include <string>

#include "twin/model/model.hpp"

namespace darwinop::twin {

/// What is done about another body file of the same name in the folder.
enum class OtherBody : std::uint8_t { kReplace, kKeep };

/// Copies the body file of `model` to where a model file in `folder` names it, unless readModel() finds the same body
/// anyway. Returns why it does not: what is wrong and what to do; empty: it does. Throws std::runtime_error if the copy
/// cannot be written.
std::string copyBody(const Model& model, const std::string& folder, OtherBody other);

}  // namespace darwinop::twin
