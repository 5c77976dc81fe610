// File of remembered robots: an error and the file kept aside, or bounded lists that read back equal.
#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "support/temporary_folder.hpp"
#include "window/transfer/remembered.hpp"

namespace {

using namespace darwinop;
using window::Remembered;
using window::RememberedFile;
using window::RobotAddress;

void require(bool holds) {
  if (!holds) std::abort();
}

bool isPrintable(const std::string& text) {
  return std::ranges::all_of(text, [](unsigned char letter) { return letter >= ' '; });
}
bool isName(const std::string& name) {
  return !name.empty() && name[0] != '-' && isPrintable(name);  // not an option of ssh
}

void requireBounds(const Remembered& all) {
  require(all.robots.size() <= RememberedFile::kMost && all.controllers.size() <= RememberedFile::kMost);
  for (const RobotAddress& robot : all.robots) {
    require(isName(robot.address) && isName(robot.user) && isPrintable(robot.key));
  }
  require(std::ranges::all_of(all.controllers, isPrintable));
}

std::string textIn(const std::string& path) {
  std::ifstream file{path, std::ios::binary};
  return {std::istreambuf_iterator<char>{file}, {}};
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const TemporaryFolder kFolder;
  const std::string path = kFolder / "robots.json", aside = path + ".damaged";
  const std::string text{reinterpret_cast<const char*>(data), size};
  std::filesystem::remove(aside);
  std::ofstream{path, std::ios::binary} << text;

  RememberedFile file{path};
  requireBounds(file.all());
  if (!file.error().empty()) {
    require(file.all().robots.empty() && file.all().controllers.empty());
    require(textIn(aside) == text && !std::filesystem::exists(path));
  }
  const RobotAddress robot{.address = "192.168.123.1", .user = "darwin", .key = "", .port = 22};
  file.note(robot, "/walker");
  const RememberedFile again{path};
  require(again.error().empty());
  requireBounds(again.all());
  require(again.all().robots == file.all().robots && again.all().controllers == file.all().controllers);
  require(again.all().robots.front() == robot && again.all().controllers.front() == "/walker");
  return 0;
}
