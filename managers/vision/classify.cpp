// Scalar colour filter, and selection of the filter for the processor.
#include "managers/vision/classify.hpp"

#include <stdexcept>

namespace darwinop::vision {

bool canUse(Instructions instructions) {
#if defined(__x86_64__) || defined(__i386__)
  if (instructions == Instructions::kAvx2) return kHasClassifyAvx2 && __builtin_cpu_supports("avx2") != 0;
  if (instructions == Instructions::kSsse3) return kHasClassifySsse3 && __builtin_cpu_supports("ssse3") != 0;
#endif
  if (instructions == Instructions::kNeon) return kHasClassifyNeon;
  return instructions == Instructions::kPlain;
}

Instructions bestInstructions() {
  for (const Instructions best : {Instructions::kAvx2, Instructions::kSsse3, Instructions::kNeon})
    if (canUse(best)) return best;
  return Instructions::kPlain;
}

Classify classifierFor(Instructions instructions) {
  if (!canUse(instructions)) throw std::invalid_argument("this processor does not support the requested instructions");
  if (instructions == Instructions::kAvx2) return classifyAvx2;
  if (instructions == Instructions::kNeon) return classifyNeon;
  return instructions == Instructions::kSsse3 ? classifySsse3 : classifyPlain;
}

void classifyPlain(const ColourTest& test, const std::uint8_t* bgra, int width, std::uint64_t* bits) {
  for (int x = 0; x < width; x += 64) {
    const int count = std::min(64, width - x);
    std::uint64_t word = 0;
    for (int bit = 0; bit < count; ++bit, bgra += 4)
      word |= std::uint64_t{passes(test, bgra[2], bgra[1], bgra[0])} << bit;
    *bits++ = word;
  }
}

}  // namespace darwinop::vision
