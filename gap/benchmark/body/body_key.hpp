// Answer key of cases of the whole robot. Stored beside the cases, read only for scoring.
#pragma once

#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace darwinop::gap {

struct BodyKeyEffect {
  std::string id;
  std::vector<std::string> at;  // joints, a link, "gyro", "floor"; "all"
  std::map<std::string, std::vector<double>> values;
};

struct BodyKey {
  std::vector<BodyKeyEffect> effects;
  bool is_exact = true;            // nothing is wrong but what is hidden
  bool is_outside = false;         // of every catalogue; `where` has its places
  std::vector<std::string> where;  // joints, or "Body"
  // Rms of joints on held-out logs, mrad: without what is hidden, and of two recordings of the same robot. NaN: not
  // known. Logs in which a robot falls do not count.
  double gap_mrad = 0, noise_mrad = 0;
};
using BodyKeys = std::map<std::string, BodyKey>;  // by name of the case

/// `id`, `at`, `params`: of a key, or of an answer.
BodyKeyEffect bodyKeyEffect(const nlohmann::ordered_json& json);

/// Throws std::runtime_error, a sentence with the file.
void writeBodyKeys(const BodyKeys& keys, const std::string& path);
BodyKeys readBodyKeys(const std::string& path);
/// True: the file is a key of such cases.
bool isBodyKey(const std::string& path);

}  // namespace darwinop::gap
