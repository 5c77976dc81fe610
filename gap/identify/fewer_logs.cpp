#include "gap/identify/fewer_logs.hpp"

#include "gap/thresholds.hpp"

namespace darwinop::gap {

FewerLogs::FewerLogs(const Study& all) : all_{all} {
  const std::vector<std::size_t>& logs = all.evidence.logs;
  if (logs.size() < thresholds::kLogsInThirds) return;
  data_ = all.data;
  data_.others.clear();
  for (std::size_t i = 0; i < logs.size(); ++i)
    if (i % 3 != 0) data_.logs[logs[i]].held_out = true;
  third_.emplace(data_);
}

}  // namespace darwinop::gap
