// Draws a figure as a PNG picture with gnuplot.
#pragma once

#include <string>

#include "experiments/logs/plot/figure.hpp"

namespace darwinop::plot {

inline constexpr int kPictureWidth = 1200;  // pixels; 180 mm at 170 dpi
[[nodiscard]] int pictureHeight(const Figure& figure);

/// Script for gnuplot's standard input. The picture is written to standard output, so the script contains no file name.
/// Texts are in single quotes, in which gnuplot interprets nothing.
[[nodiscard]] std::string gnuplotScript(const Figure& figure);

/// Returns an empty string, or a message if gnuplot is missing or failed. Throws std::runtime_error if the file cannot
/// be written.
[[nodiscard]] std::string drawPicture(const Figure& figure, const std::string& path);

}  // namespace darwinop::plot
