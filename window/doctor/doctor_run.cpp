// Reads the output of one run of darwinop-doctor.
#include "window/doctor/doctor_run.hpp"

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <string_view>

#include "window/messages.hpp"

namespace darwinop::window {
namespace {

constexpr std::size_t kStdout = 0, kStderr = 1;
constexpr std::chrono::seconds kDoctorGrace{2};
constexpr std::size_t kMaxBytesAtOnce = std::size_t{32} * 1024;  // endless output must not block the thread

std::vector<std::string> withJson(std::vector<std::string> arguments) {
  arguments.emplace_back("--json");
  return arguments;
}

/// Without the program's name and line ends.
std::string reasonIn(std::string_view text) {
  constexpr std::string_view kName = "darwinop doctor: ";
  if (text.starts_with(kName)) text.remove_prefix(kName.size());
  const std::size_t end = text.find_last_not_of("\r\n ");
  return std::string{text.substr(0, end == std::string_view::npos ? 0 : end + 1)};
}

}  // namespace

DoctorRun::DoctorRun(const DoctorCommand& command)
    : child_{"doctor", command.program, withJson(command.arguments), kDoctorGrace, Child::Stdio::kCaptured, nullptr} {}

bool DoctorRun::poll() {
  const std::optional<int> ended = child_.ended();  // checked first: all output before its end is readable then
  bool fresh = false;
  for (std::size_t stream = 0; stream < Child::kStreams; ++stream) fresh = read(stream) || fresh;
  if (fresh || !ended) return false;
  finish(*ended);
  return true;
}

bool DoctorRun::read(std::size_t stream) {
  std::array<char, 4096> bytes;
  std::size_t taken = 0;
  while (taken < kMaxBytesAtOnce) {
    const ssize_t count = ::read(child_.stream(stream), bytes.data(), bytes.size());
    if (count <= 0) break;  // no data now, or end of file
    taken += static_cast<std::size_t>(count);
    std::string& kept = output_[stream];
    kept.append(bytes.data(), std::min(static_cast<std::size_t>(count), kMostBytes - kept.size()));
  }
  return taken > 0;
}

void DoctorRun::finish(int status) {
  document_ = nlohmann::json::parse(output_[kStdout], nullptr, false);
  if (document_.is_object()) return;
  document_ = nullptr;
  error_ = reasonIn(output_[kStderr]);
  if (error_.empty()) error_ = messages::kNoDoctorDocument + std::to_string(status);
}

}  // namespace darwinop::window
