// File of remembered robots: an error and the file kept aside, or bounded lists that read back equal.
#include <algorithm>
#include <cctype>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

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

bool isPath(const std::string& text) {
  return text.size() <= 1000 &&
         std::ranges::all_of(text, [](unsigned char letter) { return letter >= ' ' && letter != 127; });
}
/// A word for ssh: not an option, and nothing that a shell expands.
bool isName(const std::string& name) {
  constexpr std::string_view kSigns = ".:%-_";
  const auto may = [&](unsigned char letter) {
    return std::isalnum(letter) != 0 || kSigns.find(static_cast<char>(letter)) != kSigns.npos;
  };
  return !name.empty() && name.size() <= 253 && name[0] != '-' && std::ranges::all_of(name, may);
}

void requireBounds(const Remembered& all) {
  require(all.robots.size() <= RememberedFile::kMost && all.controllers.size() <= RememberedFile::kMost);
  for (const RobotAddress& robot : all.robots) {
    require(isName(robot.address) && isName(robot.user) && isPath(robot.key));
  }
  require(std::ranges::all_of(all.controllers, isPath));
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
  } else {
    require(nlohmann::json::parse(text, nullptr, false).is_object());  // what is replaced was understood
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
