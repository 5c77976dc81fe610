// Request to the monitor: an error message, or bounded values.
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "monitor/messages.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace darwinop::monitor;
  const std::string_view text{reinterpret_cast<const char*>(data), size};
  std::string why;
  const auto wishes = readWishes(text, {}, why);
  const bool holds = wishes ? wishes->rate >= 0 && wishes->rate <= kMostRate && wishes->camera >= 0 &&
                                  wishes->camera <= kMostPictures && why.empty()
                            : !why.empty();
  const std::string notice = noticeText(1, 0, std::string{text});
  if (!holds || notice.front() != '{' || notice.back() != '}' || notice.find('\n') != std::string::npos) std::abort();
  return 0;
}
