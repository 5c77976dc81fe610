// Which pixels of a row have the colour, one bit each: the filter, for each kind of processor.
#pragma once

#include <cstdint>

#include "managers/vision/colour_test.hpp"

namespace darwinop::vision {

/// What the processor must be able to do. All give the same bits.
enum class Instructions { kPlain, kSsse3, kAvx2 };

/// The best of this processor.
Instructions bestInstructions();
/// False: this processor has them not, or this build knows none of them.
bool canUse(Instructions);

/// Reads 4 * width bytes, blue first, and writes (width + 63) / 64 words; pixel 0 is bit 0 of the first. Bits behind
/// the last pixel are 0.
using Classify = void (*)(const ColourTest& test, const std::uint8_t* bgra, int width, std::uint64_t* bits);
Classify classifierFor(Instructions);

void classifyPlain(const ColourTest&, const std::uint8_t* bgra, int width, std::uint64_t* bits);
/// Where these are not compiled in, they may not be called.
void classifySsse3(const ColourTest&, const std::uint8_t* bgra, int width, std::uint64_t* bits);
void classifyAvx2(const ColourTest&, const std::uint8_t* bgra, int width, std::uint64_t* bits);
/// Whether they are.
extern const bool kHasClassifySsse3;
extern const bool kHasClassifyAvx2;

}  // namespace darwinop::vision
