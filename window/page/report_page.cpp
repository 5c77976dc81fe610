// Serves a report of darwinop gap to the page.
#include "window/page/report_page.hpp"

#include <filesystem>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "core/json/json_text.hpp"
#include "hal/text_file.hpp"

namespace darwinop::window {
namespace {

constexpr std::size_t kLongestReport = std::size_t{64} * 1024 * 1024;
constexpr const char* kReportPolicy =
    "sandbox allow-scripts; default-src 'none'; style-src 'unsafe-inline'; script-src 'unsafe-inline'; img-src data:";

}  // namespace

void serveReport(web::WebServer& server, const std::string& base, const std::string& file) {
  nlohmann::json about{{"name", nullptr}};
  if (!file.empty()) {
    const auto text = readTextFile(file, kLongestReport);
    if (!text) throw std::runtime_error("--report " + file + ": no such file; give a report of darwinop gap");
    about["name"] = std::filesystem::path{file}.filename().string();
    server.serve(base + "report.html", {"text/html; charset=utf-8", *text, kReportPolicy});
  }
  server.serve(base + "report.json", {"application/json", jsonText(about)});
}

}  // namespace darwinop::window
