// Table of boards.
#include "core/board_models.hpp"

#include <gtest/gtest.h>

#include <set>

namespace darwinop {
namespace {

TEST(BoardModels, FactsOfTheCm730AloneAreConfirmed) {
  for (const BoardModel& model : kBoardModels)
    EXPECT_EQ(model.unconfirmed.empty(), model.name == "CM-730") << model.name;
}

TEST(BoardModels, ANumberIsOneModel) {
  std::set<int> numbers;
  for (const BoardModel& model : kBoardModels) {
    EXPECT_TRUE(numbers.insert(model.number).second) << model.name;
    EXPECT_EQ(findBoardModel(model.number), &model);
  }
  EXPECT_EQ(findBoardModel(0), nullptr);
}

}  // namespace
}  // namespace darwinop
