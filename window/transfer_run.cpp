#include "window/transfer_run.hpp"

#include <unistd.h>

#include <chrono>

namespace darwinop::window {
namespace {

constexpr std::size_t kOutput = 0, kComplaints = 1, kNews = 2;
constexpr std::chrono::seconds kRunGrace{2};  // who ends the window has waited before

/// Without the speaker's name and the mark of an error.
std::string sentenceOf(std::string_view line) {
  for (const std::string_view part : {"darwinop install: ", "robot: ", "error: "})
    if (line.starts_with(part)) line.remove_prefix(part.size());
  return std::string{line};
}

bool isOfInstaller(std::string_view line) {
  return line.starts_with("darwinop install: ") || line.starts_with("robot: ");
}

std::vector<std::string> watched(std::vector<std::string> words) {
  words.insert(words.begin(), "--progress");
  return words;
}

}  // namespace

TransferRun::TransferRun(const std::string& installer, const std::vector<std::string>& words, Password& password,
                         Console& console)
    : console_{console}, child_{"install",          installer, watched(words), kRunGrace, Child::Place::kHeard,
                                password.variable()} {
  password.wipe();
}

bool TransferRun::look() {
  if (status_) return false;
  const std::optional<int> ended = child_.ended();  // asked first: what it has said before is all there then
  bool fresh = false;
  for (const std::size_t stream : {kNews, kOutput, kComplaints}) fresh = take(stream) || fresh;
  if (fresh || !ended) return fresh;
  for (std::size_t i = 0; i < cutters_.size(); ++i)
    cutters_[i].end([this, i](std::string_view line) { takeLine(i, line); });
  status_ = ended;
  return true;
}

bool TransferRun::take(std::size_t stream) {
  std::array<char, 4096> bytes;
  std::size_t taken = 0;
  while (taken < kMostAtOnce) {
    const ssize_t count = read(child_.stream(stream), bytes.data(), bytes.size());
    if (count <= 0) break;  // nothing now, or never again
    taken += static_cast<std::size_t>(count);
    cutters_[stream].add({bytes.data(), static_cast<std::size_t>(count)},
                         [this, stream](std::string_view line) { takeLine(stream, line); });
  }
  return taken > 0;
}

void TransferRun::takeLine(std::size_t stream, std::string_view line) {
  if (stream == kNews) return takeNews(line);
  if (stream == kOutput) return console_.add(LineKind::kOutput, line);
  complaint_ = kindOfComplaint(line, complaint_);
  console_.add(complaint_, line);
  if (isOfInstaller(line)) (complaint_ == LineKind::kError ? error_ : said_) = sentenceOf(line);
}

void TransferRun::takeNews(std::string_view line) {
  if (std::optional<InstallerStep> step = readStep(line)) step_ = std::move(step);
  if (const std::string_view key = readHostKey(line); !key.empty()) host_key_ = key;
}

void TransferRun::cancel() {
  if (cancelled_ || status_) return;
  cancelled_ = true;
  child_.interrupt();
}

}  // namespace darwinop::window
