// Serves a report of darwinop gap to the page.
#include "window/report_page.hpp"

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <stdexcept>

namespace darwinop::window {
namespace {

constexpr std::uintmax_t kLongestReport = std::uintmax_t{64} * 1024 * 1024;
constexpr const char* kReportPolicy =
    "sandbox allow-scripts; default-src 'none'; style-src 'unsafe-inline'; script-src 'unsafe-inline'; img-src data:";

}  // namespace

void serveReport(web::WebServer& server, const std::string& base, const std::string& file) {
  nlohmann::json about{{"name", nullptr}};
  if (!file.empty()) {
    std::error_code unknown;
    // Opening a pipe would block until it has a writer.
    const bool regular = std::filesystem::is_regular_file(file, unknown);
    std::ifstream in;
    if (regular) in.open(file, std::ios::binary);
    if (!regular || !in || std::filesystem::file_size(file, unknown) > kLongestReport || unknown)
      throw std::runtime_error("--report " + file +
                               ": not a readable file of at most 64 MB; give a report of darwinop gap");
    std::ostringstream text;
    text << in.rdbuf();
    about["name"] = std::filesystem::path{file}.filename().string();
    server.serve(base + "report.html", {"text/html; charset=utf-8", text.str(), kReportPolicy});
  }
  const auto replace = nlohmann::json::error_handler_t::replace;
  server.serve(base + "report.json", {"application/json", about.dump(-1, ' ', false, replace)});
}

}  // namespace darwinop::window
