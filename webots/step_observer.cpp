// List of those who follow the steps of the robot.
#include "webots/step_observer.hpp"

#include <vector>

namespace darwinop::webots_api {

namespace {

// Never destroyed: a manager may be a global object of the controller.
std::vector<StepObserver*>& observers() {
  static auto* const list = new std::vector<StepObserver*>;
  return *list;
}

}  // namespace

StepObserver::StepObserver() {
  observers().push_back(this);
}

StepObserver::~StepObserver() {
  std::erase(observers(), this);
}

void notifyBeforeStep(int ms) {
  for (StepObserver* const observer : observers()) observer->beforeStep(ms);
}

void notifyBeforeEnd() {
  for (StepObserver* const observer : observers()) observer->beforeEnd();
}

}  // namespace darwinop::webots_api
