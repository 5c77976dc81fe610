// The folder of a case: its case.json, its logs and its model.
#include <filesystem>
#include <optional>

#include "experiments/logs/read_log.hpp"
#include "gap/case/messages.hpp"
#include "gap/case/parse_case.hpp"
#include "hal/text_file.hpp"

namespace darwinop::gap {
namespace {

namespace fs = std::filesystem;

logs::Log readRegularLog(const fs::path& path) {
  if (fs::exists(path) && !fs::is_regular_file(path))  // opening a pipe waits for its writer
    throw std::runtime_error("cannot read the log " + path.string() + ": " + messages::kNotRegular);
  return logs::readLog(path.string());
}

}  // namespace

std::string caseTextIn(const std::string& folder) {
  if (!fs::is_directory(folder)) throw BadInput(folder + messages::kNoFolder);
  const std::string file = (fs::path{folder} / "case.json").string();
  std::optional<std::string> text;
  try {
    text = readTextFile(file);
  } catch (const std::runtime_error& error) {
    throw BadInput(error.what());
  }
  if (!text)
    throw BadInput(
        file +
        ": there is no such file. It lists the logs of a case and its model: copy "
        "the one of the shipped example and change it, docs/gap/cases.md explains each key; `darwinop gap run` "
        "makes one of raw logs");
  return *text;
}

CaseFiles filesIn(const std::string& folder) {
  return {
      .log = [=](const std::string& name) { return readRegularLog(fs::path{folder} / name); },
      .model =
          [=](const std::string& name) {
            const fs::path beside = fs::path{folder} / name;
            return twin::readModel(fs::exists(beside) ? beside.string() : twin::findModel(name));
          },
  };
}

Case readCase(const std::string& folder) {
  return parseCase(caseTextIn(folder), (fs::path{folder} / "case.json").string(), filesIn(folder));
}

}  // namespace darwinop::gap
