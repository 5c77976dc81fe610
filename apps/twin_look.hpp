// Options of every command that shows the twin: which model, from where, how large.
#pragma once

#include <CLI/CLI.hpp>

#include "twin/view/show.hpp"

void describeLook(CLI::App& command, darwinop::twin::ShowOptions& show);
