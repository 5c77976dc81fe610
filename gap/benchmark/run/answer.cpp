#include "gap/benchmark/run/answer.hpp"

#include <chrono>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/text/formatted.hpp"
#include "core/text/joined.hpp"
#include "gap/case/body/body_case.hpp"
#include "gap/identify/body/body_identification.hpp"
#include "gap/report/data_hash.hpp"
#include "gap/report/results.hpp"
#include "hal/text_file.hpp"

namespace darwinop::gap {
namespace {

using nlohmann::json;

constexpr std::size_t kLongestWhy = 70;                     // columns
constexpr std::size_t kLongestFile = std::size_t{1} << 30;  // bytes

json failed(const std::string& name, const std::string& why) {
  json answer = badInput(name, why);
  answer["verdict"] = "error";
  return answer;
}

/// Of a servo an alternative is an id; of a whole robot it has a place as well.
std::string idOf(const json& alternative) {
  return alternative.is_object() ? alternative.at("id").get<std::string>() : alternative.get<std::string>();
}

std::string findingOf(const json& answer) {
  const std::string verdict = answer.at("verdict");
  if (verdict == "ambiguous" && !answer.at("ambiguity").empty()) {
    std::vector<std::string> alternatives;
    for (const json& one : answer.at("ambiguity").front()) alternatives.push_back(idOf(one));
    return verdict + ": " + text::joined(alternatives, " or ");
  }
  std::vector<std::string> ids;
  for (const json& effect : answer.at("effects")) ids.push_back(effect.at("id").get<std::string>());
  return ids.empty() ? verdict : verdict + " " + text::joined(ids, " + ");
}

json ofServo(const Case& given) {
  return asJson(given, investigate(given));
}

json ofBody(const BodyCase& given) {
  return asJson(given, identify(given));
}

/// Without the way to the case, which all lines would have, and to the width of a line.
std::string shortened(std::string why, const std::string& name) {
  if (const std::size_t at = why.find("/" + name + "/"); at != std::string::npos) why.erase(0, at + name.size() + 2);
  if (why.size() <= kLongestWhy) return why;
  std::size_t end = kLongestWhy;
  while (end > 0 && (static_cast<unsigned char>(why[end]) & 0xc0) == 0x80) --end;  // not within a letter of UTF-8
  return why.substr(0, end) + "…";
}

}  // namespace

json answerFor(const std::string& folder) {
  const auto begin = std::chrono::steady_clock::now();
  const std::string name = std::filesystem::path{folder}.filename().string();
  json answer;
  try {
    answer = isBodyCase(folder) ? ofBody(readBodyCase(folder)) : ofServo(readCase(folder));
  } catch (const BadInput& bad) {
    answer = badInput(name, bad.what());
  } catch (const std::exception& error) {
    answer = failed(name, error.what());
  }
  answer["case"] = name;
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  answer["runtime_s"] = std::round(seconds * 10) / 10;
  return answer;
}

std::string fingerprintOf(const std::string& folder) try {
  const auto textOf = [&](const std::string& file) {
    return readTextFile((std::filesystem::path{folder} / file).string(), kLongestFile).value_or("");
  };
  const std::string text = textOf("case.json");
  if (text.empty()) return "";
  std::string hashes = sha256(text);
  const json declared = json::parse(text, nullptr, false);
  if (declared.is_object() && declared.contains("logs") && declared["logs"].is_array())
    for (const json& log : declared["logs"])
      if (log.is_object() && log.contains("file") && log["file"].is_string())
        hashes += " " + sha256(textOf(log["file"].get<std::string>()));
  return sha256(hashes);
} catch (const std::runtime_error&) {
  return "";  // answerFor() reports it
}

std::string lineOf(const json& answer) {
  std::string line = answer.at("case").get<std::string>() + "  ";
  if (const auto why = answer.find("why"); why != answer.end() && why->is_string()) {
    return line + answer.at("verdict").get<std::string>() + ": " + shortened(*why, answer.at("case"));
  }
  line += findingOf(answer);
  const json before = answer.value("gap_score_before_mrad", json{}),
             after = answer.value("gap_score_after_mrad", json{});
  if (before.is_number() && after.is_number())
    line += text::formatted("  %.2f", before.get<double>()) + text::formatted(" -> %.2f mrad", after.get<double>());
  return line + text::formatted("  %.1f s", answer.at("runtime_s").get<double>());
}

}  // namespace darwinop::gap
