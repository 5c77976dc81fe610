// JPEG from the network: an error, or a whole image, independent of earlier ones. The library itself gives no coverage.
#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <vector>

#include "remote/jpeg/decoder.hpp"

namespace {

using namespace darwinop::remote;

void require(bool holds) {
  if (!holds) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  // The first byte chooses the size that is expected; those of the corpus are 40x30.
  const ImageSize expected{kImageWidths[3 - data[0] % 4], kImageHeights[3 - data[0] / 4 % 4]};
  const std::span jpeg{data + 1, size - 1};
  const std::size_t bytes = std::size_t{4} * expected.width * expected.height;

  std::vector<std::uint8_t> bgra(bytes), again(bytes, 1);
  const char* wrong = decodeJpeg(jpeg, expected, bgra);
  const char* wrong_again = decodeJpeg(jpeg, expected, again);
  require((wrong == nullptr) == (wrong_again == nullptr));
  if (wrong != nullptr) {
    require(*wrong != '\0');
    return 0;
  }
  require(bgra == again);
  for (std::size_t alpha = 3; alpha < bytes; alpha += 4) require(bgra[alpha] == 255);
  return 0;
}
