// Which logs of a folder verify the result.
#include <algorithm>
#include <filesystem>

#include "gap/case/messages.hpp"
#include "gap/case/raw_folder.hpp"

namespace darwinop::gap {
namespace {

std::string stemOf(const std::string& file) {
  return std::filesystem::path{file}.stem().string();
}

}  // namespace

std::vector<Prior> benchPriors() {
  return {{"kt", 0.1}, {"resistance", 0.15}, {"armature", 0.5}, {"payload", 0.02}, {"length", 0.02}};
}

void holdOut(const std::vector<std::string>& names, FolderCase& in) {
  std::vector<Trajectory>& logs = in.given.logs;
  for (const std::string& name : names)
    if (std::ranges::none_of(logs, [&](const Trajectory& log) { return stemOf(log.file) == stemOf(name); }))
      throw BadInput("--keep " + name + messages::kNotLogOfFolder + in.given.folder);
  const double greatest = std::ranges::max(logs, {}, &Trajectory::p_register).p_register;
  const auto of_greatest = static_cast<std::size_t>(std::ranges::count(logs, greatest, &Trajectory::p_register));
  // Of two logs one is fitted: no choice leaves enough.
  const std::size_t most = logs.size() < kFewestFitted ? logs.size() / 2 : logs.size() - kFewestFitted;
  const bool by_gain = 2 * of_greatest <= logs.size() && of_greatest <= most;
  const std::size_t quarter = std::min((logs.size() + 3) / 4, most);
  for (std::size_t i = 0; i < logs.size(); ++i) {
    const std::string stem = stemOf(logs[i].file);
    const bool named = std::ranges::any_of(names, [&](const std::string& name) { return stemOf(name) == stem; });
    logs[i].held_out = !names.empty() ? named : by_gain ? logs[i].p_register == greatest : i + quarter >= logs.size();
  }
  const auto held = std::ranges::count_if(logs, &Trajectory::held_out);
  if (static_cast<std::size_t>(held) == logs.size()) throw BadInput(in.given.folder + messages::kKeepsAll);
  if (names.empty())
    in.notes.push_back(std::to_string(held) + " of " + std::to_string(logs.size()) + " logs are held out: " +
                       (by_gain ? "those of the greatest kp" : "the last quarter") + "; choose others with --keep");
}

}  // namespace darwinop::gap
