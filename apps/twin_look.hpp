// Common options of commands that render the twin: model, viewpoint, size.
#pragma once

#include <CLI/CLI.hpp>

#include "twin/view/show.hpp"

void describeLook(CLI::App& command, darwinop::twin::ShowOptions& show);
