// Request to the monitor: an error message, or bounded values.
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "monitor/messages.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace darwinop::monitor;
  const std::string_view text{reinterpret_cast<const char*>(data), size};
  std::string why;
  const auto subscription = parseSubscription(text, {}, why);
  const bool holds = subscription
                         ? subscription->rate >= 0 && subscription->rate <= kMostRate && subscription->camera >= 0 &&
                               subscription->camera <= kMostPictures && why.empty()
                         : !why.empty();
  const std::string notice = noticeText(1, 0, std::string{text});
  if (!holds || notice.front() != '{' || notice.back() != '}' || notice.find('\n') != std::string::npos) std::abort();
  return 0;
}
