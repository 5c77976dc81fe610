// What needs no more than some of many logs: a search for two effects that explain all, the best of several starts.
#pragma once

#include <optional>

#include "gap/study.hpp"

namespace darwinop::gap {

/// Every third of the fit logs of a study, gains and motions as mixed as in all; all, if they are few.
class FewerLogs {
 public:
  /// `all` must outlive this.
  explicit FewerLogs(const Study& all);
  FewerLogs(const FewerLogs&) = delete;
  FewerLogs& operator=(const FewerLogs&) = delete;

  [[nodiscard]] const Study& study() const { return third_ ? *third_ : all_; }

 private:
  const Study& all_;
  Case data_;
  std::optional<Study> third_;
};

}  // namespace darwinop::gap
