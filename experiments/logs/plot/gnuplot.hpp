// The figure as a PNG picture, drawn by gnuplot.
#pragma once

#include <string>

#include "experiments/logs/plot/figure.hpp"

namespace darwinop::plot {

inline constexpr int kPictureWidth = 1200;  // pixels; prints at 180 mm with 170 dots an inch
[[nodiscard]] int pictureHeight(const Figure& figure);

/// What gnuplot reads on its standard input; the picture leaves on its standard output, so that no file name stands
/// in the script. Texts stand in single quotes, where gnuplot obeys nothing.
[[nodiscard]] std::string gnuplotScript(const Figure& figure);

/// Empty: the picture is there. Otherwise a sentence why it is not: gnuplot is missing or failed.
/// Throws std::runtime_error when the file cannot be written.
[[nodiscard]] std::string drawPicture(const Figure& figure, const std::string& path);

}  // namespace darwinop::plot
