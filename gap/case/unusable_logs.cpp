// Logs of a raw folder that cannot be used.
#include "gap/case/bad_rows.hpp"
#include "gap/case/grouped_notes.hpp"
#include "gap/case/messages.hpp"
#include "gap/case/raw_folder.hpp"

namespace darwinop::gap {
namespace {

constexpr double kFewUnusable = kMostMasked;  // of the files, as of the rows of a log
constexpr double kMostUnusable = 0.5;         // faults come in groups: all logs of one gain, or of one day

}  // namespace

void refuseUnusable(const FolderCase& in) {
  if (in.unusable.size() == 1) throw BadInput(in.unusable.front());
  std::string text = std::to_string(in.unusable.size()) + " of " +
                     std::to_string(in.given.logs.size() + in.unusable.size()) + " logs of " + in.given.folder +
                     messages::kUnusableLogs;
  for (const std::string& reason : grouped(in.unusable)) text += "\n  " + reason;
  throw BadInput(text);
}

void noteUnusable(FolderCase& in) {
  const auto unusable = static_cast<double>(in.unusable.size());
  const double files = unusable + static_cast<double>(in.given.logs.size());
  const bool enough = in.given.logs.size() >= kFewestFitted && unusable <= kMostUnusable * files;
  if (in.given.logs.empty() || (!enough && unusable > kFewUnusable * files)) refuseUnusable(in);
  for (const std::string& reason : in.unusable) in.notes.push_back(messages::kLeftOut + reason);
}

}  // namespace darwinop::gap
