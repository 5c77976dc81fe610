// Cases of the whole robot.
#include <iostream>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "core/json/json_text.hpp"
#include "gap/case/body/body_check.hpp"
#include "gap/identify/body/body_identification.hpp"
#include "gap_commands.hpp"

namespace darwinop::gap {
namespace {

BodyCase readBody(const Arguments& given) {
  BodyCase read = readBodyCase(given.folder);
  if (!given.model.empty()) read.joints.model = twin::readModel(twin::findModel(given.model));
  for (const std::string& warning : read.warnings) std::cerr << "darwinop gap: " << warning << '\n';
  return read;
}

}  // namespace

int checkBody(const Arguments& given) {
  const BodyCase read = readBody(given);
  std::cout << asText(read, checkData(read));
  return 0;
}

int locateBody(const Arguments& given) {
  const BodyCase read = readBody(given);
  const BodyTable table = localize(read, RestingImu{read.joints.model});
  std::cout << (given.json ? jsonText(asJson(table), 1) + "\n" : asText(table));
  return 0;
}

int runBody(const Arguments& given) {
  if (!given.out.empty() || !given.report.empty() || given.open)
    throw std::runtime_error(
        "--out, --report and --open: a whole robot has neither model file nor report yet; use --json");
  const BodyCase read = readBody(given);
  const BodyIdentification found = identify(read);
  std::cout << (given.json ? jsonText(asJson(read, found), 1) + "\n" : asText(found));
  return exitCodeOf(found.verdict);
}

}  // namespace darwinop::gap
