#include "gap/case/declared_case.hpp"

#include <filesystem>

#include "gap/case/fields.hpp"

namespace darwinop::gap {

void readDeclared(const std::string& json, const Declarations& declared, CaseFiles files, FolderCase& into) {
  Json whole = parseJson(json, "declared");
  for (const char* const key : {"goal_order", "axis"})
    if (const auto word = declared.text(key)) whole[key] = *word;
  for (Json& entry : whole["logs"])
    for (const char* const key : {"from_s", "to_s", "hangs_at_rad"})
      if (const auto value = declared.number(key)) entry[key] = *value;
  for (const auto& [column, encoding] : declared.encodings()) whole["encodings"][column] = encoding;
  for (const auto& [number, sigma] : declared.sigmas()) whole["prior_rel_sigma"][number] = sigma;
  const twin::Model model = into.given.model;
  files.model = [&](const std::string&) { return model; };
  files.leave_out = [&](const BadInput& reason) { into.unusable.emplace_back(reason.what()); };
  const std::string name = (std::filesystem::path{into.given.folder} / "declared").string();
  into.given = parseCase(whole.dump(), name, files);
}

}  // namespace darwinop::gap
