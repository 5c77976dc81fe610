// Serves a report of darwinop gap to the page.
#pragma once

#include <string>

#include "hal/net/web/server.hpp"

namespace darwinop::window {

/// Serves `file` as report.html and its name in report.json; empty: no report. The report is sandboxed: it may run its
/// own scripts but cannot access the window or the network. Throws std::runtime_error.
void serveReport(web::WebServer& server, const std::string& base, const std::string& file);

}  // namespace darwinop::window
