// Reads output and progress of one run of darwinop-install.
#include "window/transfer/transfer_run.hpp"

#include <unistd.h>

#include <chrono>

namespace darwinop::window {
namespace {

constexpr std::size_t kStdout = 0, kStderr = 1, kProgress = 2;
constexpr std::chrono::seconds kRunGrace{2};  // ~Transfer() has waited before

/// Without the program's name and the prefix "error: ".
std::string withoutPrefix(std::string_view line) {
  for (const std::string_view part : {"darwinop install: ", "robot: ", "error: "})
    if (line.starts_with(part)) line.remove_prefix(part.size());
  return std::string{line};
}

bool isFromInstaller(std::string_view line) {
  return line.starts_with("darwinop install: ") || line.starts_with("robot: ");
}

std::vector<std::string> withProgress(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), "--progress");
  return arguments;
}

}  // namespace

TransferRun::TransferRun(const std::string& installer, const std::vector<std::string>& arguments, Password& password,
                         Console& console)
    : console_{console},
      child_{"install", installer, withProgress(arguments), kRunGrace, Child::Stdio::kCaptured, password.variable()} {
  password.wipe();
}

bool TransferRun::poll() {
  if (status_) return false;
  const std::optional<int> ended = child_.ended();  // checked first: all output before its end is readable then
  bool fresh = false;
  for (const std::size_t stream : {kProgress, kStdout, kStderr}) fresh = readStream(stream) || fresh;
  if (fresh || !ended) return fresh;
  for (std::size_t i = 0; i < splitters_.size(); ++i)
    splitters_[i].end([this, i](std::string_view line) { takeLine(i, line); });
  status_ = ended;
  return true;
}

bool TransferRun::readStream(std::size_t stream) {
  std::array<char, 4096> bytes;
  std::size_t taken = 0;
  while (taken < kMaxBytesAtOnce) {
    const ssize_t count = read(child_.stream(stream), bytes.data(), bytes.size());
    if (count <= 0) break;  // no data now, or end of file
    taken += static_cast<std::size_t>(count);
    splitters_[stream].add({bytes.data(), static_cast<std::size_t>(count)},
                           [this, stream](std::string_view line) { takeLine(stream, line); });
  }
  return taken > 0;
}

void TransferRun::takeLine(std::size_t stream, std::string_view line) {
  if (stream == kProgress) return takeProgress(line);
  if (stream == kStdout) return console_.add(LineKind::kOutput, line);
  stderr_kind_ = classifyStderrLine(line, stderr_kind_);
  console_.add(stderr_kind_, line);
  if (isFromInstaller(line)) (stderr_kind_ == LineKind::kError ? error_ : message_) = withoutPrefix(line);
}

void TransferRun::takeProgress(std::string_view line) {
  if (std::optional<InstallerStep> step = readStep(line)) step_ = std::move(step);
  if (const std::string_view key = readHostKey(line); !key.empty()) host_key_ = key;
}

}  // namespace darwinop::window
