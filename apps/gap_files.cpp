#include "gap_files.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cctype>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <iostream>
#include <optional>
#include <stdexcept>
#include <system_error>

#include "core/text/shell_word.hpp"
#include "gap/report/data_hash.hpp"
#include "hal/process/child_process.hpp"
#include "hal/text_file.hpp"
#include "hal/write_text_file.hpp"

namespace darwinop::gap {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kLongestText = 64 << 20;  // bytes: of a report, as darwinop window takes it

/// A name of a case that is also one of a folder.
std::string folderName(const std::string& name) {
  std::string out;
  for (const char c : name) {
    const bool plain =
        std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '-' || (c == '.' && !out.empty());
    out += plain ? c : '_';
  }
  return out.empty() ? "case" : out;
}

/// Where a person sits in front of a screen; not at the far end of an ssh.
bool someoneIsThere() {
  const auto set = [](const char* name) {
    const char* const value = std::getenv(name);
    return value != nullptr && *value != '\0';
  };
  return isatty(STDOUT_FILENO) == 1 && (set("DISPLAY") || set("WAYLAND_DISPLAY")) && !set("SSH_CONNECTION");
}

/// The desktop's own program for pages; nothing happens where there is none.
void openInBrowser(const std::string& path) try {
  using process::Stream;
  process::ChildProcess{{.command = {"xdg-open", path}, .streams = {{}, Stream::nothing(), Stream::nothing()}}}
      .detach();
} catch (const std::runtime_error&) {
  std::cerr << "darwinop gap: xdg-open not found; open the page yourself\n";
}

}  // namespace

std::string textOf(const std::string& path) {
  const std::optional<std::string> text = readTextFile(path, kLongestText);
  if (!text) throw std::runtime_error("cannot read " + path + ": " + std::strerror(errno));
  return *text;
}

void requireNew(const std::string& path) {
  if (fs::exists(path)) throw std::runtime_error(path + messages::kOutExists);
}

void makeFolder(const std::string& path) {
  std::error_code failed;
  fs::create_directories(path, failed);
  if (failed) throw std::runtime_error("cannot make the folder " + path + ": " + failed.message());
}

std::string newCaseFile(const std::string& folder) {
  std::string file = fs::path{folder} / "case.json";
  requireNew(file);
  return file;
}

void requireWritable(const std::string& path) {
  const bool is_new = !fs::exists(path);
  const int file = open(path.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0666);
  if (file < 0) throw std::runtime_error("cannot write " + path + ": " + std::strerror(errno));
  close(file);
  if (is_new) unlink(path.c_str());
}

void requireReportFolder(const std::string& path) {
  fs::path there = fs::absolute(path);
  while (!fs::exists(there) && there.has_relative_path()) there = there.parent_path();
  if (!fs::is_directory(there)) throw std::runtime_error(there.string() + messages::kNoReportFolder);
  if (access(there.c_str(), W_OK | X_OK) != 0)
    throw std::runtime_error("cannot write in " + there.string() + ": " + std::strerror(errno) +
                             messages::kOtherReport);
}

void putBody(const twin::Model& model, const std::string& folder, twin::OtherBody other) {
  if (const std::string wrong = twin::copyBody(model, folder, other); !wrong.empty())
    std::cerr << "darwinop gap: " << wrong << '\n';
}

void writeModelFile(const std::string& path, const std::string& text, const twin::Model& model) {
  writeTextFile(path, text);
  putBody(model, fs::path{path}.parent_path().string(), twin::OtherBody::kKeep);
}

std::string reportFolder(const Arguments& given, const std::string& otherwise) {
  return given.report.empty() ? (fs::path{"gap-report"} / folderName(otherwise)).string() : given.report;
}

void showReport(const Arguments& given, const std::string& folder, bool has_effects) {
  const std::string page = (fs::path{folder} / "report.html").string();
  std::cerr << "darwinop gap: " << page << " is the report; report.json beside it is for programs"
            << (has_effects ? messages::kModelOfReport : "") << '\n';
  if (given.open || (!given.no_open && !given.json && someoneIsThere())) openInBrowser(page);
}

std::string modelOption(const Arguments& given) {
  return given.model.empty() ? "" : " --model " + text::shellWord(given.model);
}

}  // namespace darwinop::gap
