// Joins the ranks before the tests and leaves them after, as main() of darwinop-gap does.
#include "gap/parallel/ranks.hpp"

#include <gtest/gtest.h>

#include <memory>

namespace darwinop::gap {
namespace {

class JoinedRanks : public testing::Environment {
 public:
  void SetUp() override { ranks_ = std::make_unique<Ranks>(); }
  void TearDown() override { ranks_.reset(); }

 private:
  std::unique_ptr<Ranks> ranks_;
};

// NOLINTNEXTLINE(cppcoreguidelines-avoid-non-const-global-variables): interface of GoogleTest
[[maybe_unused]] testing::Environment* const kRanks = testing::AddGlobalTestEnvironment(new JoinedRanks);

}  // namespace
}  // namespace darwinop::gap
