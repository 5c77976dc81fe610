#include "hil-mocks/camera/picture_folder.hpp"

#include <lodepng.h>

#include <algorithm>
#include <cctype>
#include <fstream>
#include <stdexcept>
#include <string>
#include <system_error>

namespace darwinop::hil {
namespace {

namespace fs = std::filesystem;

constexpr int kMostSide = 10'000;  // px; larger files are damaged

[[noreturn]] void fail(const fs::path& file, const std::string& why) {
  throw std::runtime_error("cannot read the picture " + file.string() + ": " + why);
}

std::string ending(const fs::path& file) {
  std::string text = file.extension().string();
  std::ranges::transform(text, text.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

PaintedPicture fromRgb(int width, int height, const std::uint8_t* rgb) {
  PaintedPicture picture{width, height};
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x, rgb += 3) picture.set(x, y, {rgb[0], rgb[1], rgb[2]});
  return picture;
}

PaintedPicture readPng(const fs::path& file) {
  std::vector<std::uint8_t> rgb;
  unsigned width = 0, height = 0;
  const unsigned error = lodepng::decode(rgb, width, height, file.string(), LCT_RGB);
  if (error != 0) fail(file, std::string{lodepng_error_text(error)} + "; " + kSavePngAgain + ", or remove it");
  return fromRgb(static_cast<int>(width), static_cast<int>(height), rgb.data());
}

/// The next number of a PPM header; # starts a comment. -1: none.
int number(std::istream& in) {
  while ((in >> std::ws).peek() == '#') in.ignore(kMostSide, '\n');
  int value = -1;
  return in >> value ? value : -1;
}

PaintedPicture readPpm(const fs::path& file) {
  std::ifstream in{file, std::ios::binary};
  if (!in) fail(file, "cannot open it; check its permissions");
  char kind[2] = {};
  in.read(kind, sizeof kind);
  const int width = number(in), height = number(in), most = number(in);
  if (kind[0] != 'P' || kind[1] != '6' || most != 255 || width < 1 || height < 1 || width > kMostSide ||
      height > kMostSide)
    fail(file, "not a binary PPM (P6) with maximum value 255; convert it to that, or to PNG");
  in.get();  // one whitespace character
  std::vector<std::uint8_t> rgb(3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  in.read(reinterpret_cast<char*>(rgb.data()), static_cast<std::streamsize>(rgb.size()));
  if (!in) fail(file, "the file is truncated; copy it again");
  return fromRgb(width, height, rgb.data());
}

}  // namespace

PaintedPicture readPicture(const fs::path& file) {
  if (fs::exists(file) && !fs::is_regular_file(file)) fail(file, std::string{kNotRegularFile} + "; remove it");
  return ending(file) == ".ppm" ? readPpm(file) : readPng(file);
}

PictureFolder::PictureFolder(const fs::path& folder, std::uint32_t frames_each)
    : frames_each_{std::max(frames_each, 1u)} {
  std::error_code error;
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : fs::directory_iterator{folder, error})
    if (ending(entry.path()) == ".png" || ending(entry.path()) == ".ppm") files.push_back(entry.path());
  if (error) throw std::runtime_error("cannot read picture folder " + folder.string() + ": " + error.message());
  if (files.empty()) throw std::runtime_error("no pictures in " + folder.string() + ": add .png or .ppm files");
  std::ranges::sort(files);
  for (const fs::path& file : files) pictures_.push_back(readPicture(file));
}

void PictureFolder::draw(PaintedPicture& onto, std::uint32_t frame) const {
  const PaintedPicture& from = pictures_[frame / frames_each_ % pictures_.size()];
  for (int y = 0; y < onto.height; ++y)
    for (int x = 0; x < onto.width; ++x)
      onto.set(x, y,
               from.colour((2 * x + 1) * from.width / (2 * onto.width), (2 * y + 1) * from.height / (2 * onto.height)));
}

}  // namespace darwinop::hil
