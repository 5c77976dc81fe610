// A report of darwinop gap, linked in the page.
#pragma once

#include <string>

#include "hal/net/web/server.hpp"

namespace darwinop::window {

/// Serves `file` as report.html, and its name in report.json; an empty `file`: there is none. The report may run what
/// it brings along and reach nothing else, this window included. Throws std::runtime_error.
void serveReport(web::Server& server, const std::string& base, const std::string& file);

}  // namespace darwinop::window
