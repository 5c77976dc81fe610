// One run of darwinop-doctor: its JSON document, or why there is none.
#pragma once

#include <array>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "window/child.hpp"
#include "window/doctor/doctor_command.hpp"

namespace darwinop::window {

class DoctorRun {
 public:
  /// Bytes kept of each output; the document of a robot with every servo faulty has 30 kB.
  static constexpr std::size_t kMostBytes = std::size_t{512} * 1024;

  /// Starts it. Throws std::runtime_error.
  explicit DoctorRun(const DoctorCommand& command);

  /// Reads available output, non-blocking. True: it has ended and all its output has been read.
  bool poll();
  /// Its document; null: none, see error().
  [[nodiscard]] const nlohmann::json& document() const { return document_; }
  /// What it printed instead of a document, or how it ended.
  [[nodiscard]] const std::string& error() const { return error_; }

 private:
  bool read(std::size_t stream);
  void finish(int status);

  Child child_;
  std::array<std::string, Child::kStreams> output_{};
  nlohmann::json document_{};
  std::string error_{};
};

}  // namespace darwinop::window
