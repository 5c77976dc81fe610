// Each case of the whole robot with what is hidden and what was answered, as a table in Markdown.
#pragma once

#include <string>

#include "gap/benchmark/score/body/body_answers.hpp"

namespace darwinop::gap {

/// In the order of the keys. Numbers as in key and answer; "missed" as bodyScoreOf() counts, so also an answer that is
/// late.
std::string bodyCaseTable(const BodyKeys& keys, const BodyAnswers& answers);

}  // namespace darwinop::gap
