// How many cases of an exhaustive test run: all of them, or one in seven under the address sanitizer, which makes each
// ten times as long and looks at memory, not at answers. The robot's build (stage i686) and the debug build run every
// case.
#pragma once

#if defined(__has_feature)
#if __has_feature(address_sanitizer)
#define DARWINOP_ONE_CASE_IN_SEVEN
#endif
#endif

namespace darwinop {

/// Distance between cases; odd, so that each bit of a case's number takes both values.
#ifdef DARWINOP_ONE_CASE_IN_SEVEN
inline constexpr int kNextCase = 7;
#else
inline constexpr int kNextCase = 1;
#endif

}  // namespace darwinop
