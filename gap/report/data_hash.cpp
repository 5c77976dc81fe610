#include "gap/report/data_hash.hpp"

#include <sha2.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>

#include "core/text/shell_word.hpp"
#include "hal/text_file.hpp"

namespace darwinop::gap {
namespace {

std::vector<std::string> filesOf(const Case& given) {
  std::vector<std::string> files{"case.json"};
  for (const Trajectory& log : given.logs) files.push_back(log.file);
  for (const Trajectory& log : given.others) files.push_back(log.file);
  return files;
}

}  // namespace

std::string sha256(std::string_view data) {
  std::array<char, SHA256_DIGEST_STRING_LENGTH> text{};
  return SHA256Data(reinterpret_cast<const std::uint8_t*>(data.data()), data.size(), text.data());
}

std::string dataHash(const Case& given) {
  return dataHash(given.folder, filesOf(given));
}

std::string dataHash(const std::string& folder, const std::vector<std::string>& files) {
  std::string all;
  for (const std::string& name : files) {
    const auto text = folder.empty() ? std::nullopt : readTextFile(std::filesystem::path{folder} / name, kAnyLength);
    if (!text) return "";
    all += *text;
  }
  return sha256(all);
}

std::string hashCommand(const Case& given) {
  std::string command = "cat";
  for (const std::string& name : filesOf(given)) command += " " + text::shellWord(name);
  return command + " | sha256sum";
}

}  // namespace darwinop::gap
