// Colour filter: one bit per pixel of a row, with SIMD variants.
#pragma once

#include <cstdint>

#include "managers/vision/colour_test.hpp"

namespace darwinop::vision {

/// Required instruction set. All variants give the same bits.
enum class Instructions { kPlain, kSsse3, kAvx2, kNeon };
inline constexpr Instructions kAllInstructions[] = {Instructions::kPlain, Instructions::kSsse3, Instructions::kAvx2,
                                                    Instructions::kNeon};

/// The fastest variant that this processor supports.
Instructions bestInstructions();
/// False if the processor or this build does not support it.
bool canUse(Instructions);

/// Reads 4 * width bytes (BGRA) and writes (width + 63) / 64 words; pixel 0 is bit 0 of the first. Padding bits are 0.
using Classify = void (*)(const ColourTest& test, const std::uint8_t* bgra, int width, std::uint64_t* bits);
Classify classifierFor(Instructions);

void classifyPlain(const ColourTest&, const std::uint8_t* bgra, int width, std::uint64_t* bits);
/// Call only if compiled in, see the constants below.
void classifySsse3(const ColourTest&, const std::uint8_t* bgra, int width, std::uint64_t* bits);
void classifyAvx2(const ColourTest&, const std::uint8_t* bgra, int width, std::uint64_t* bits);
void classifyNeon(const ColourTest&, const std::uint8_t* bgra, int width, std::uint64_t* bits);
extern const bool kHasClassifySsse3;
extern const bool kHasClassifyAvx2;
extern const bool kHasClassifyNeon;

}  // namespace darwinop::vision
