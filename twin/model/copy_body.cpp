#include "twin/model/copy_body.hpp"

#include <filesystem>

#include "hal/text_file.hpp"
#include "twin/model/messages.hpp"
#include "twin/model/shipped.hpp"

namespace darwinop::twin {

namespace fs = std::filesystem;

std::string copyBody(const Model& model, const std::string& folder, OtherBody other) {
  const fs::path body = fs::path{model.folder} / model.body.xml;
  if (model.file.empty() || !isFile(body)) return {};  // of a model of servos
  const fs::path into = folder.empty() ? "." : folder, copy = into / model.body.xml;
  const fs::path found = fs::path{bodyFolder((into / "model.ini").string(), model.body.xml)} / model.body.xml;
  if (isFile(found) && readTextFile(found.string()) == readTextFile(body.string())) return {};
  if (*fs::path{model.body.xml}.lexically_normal().begin() == "..")
    return "[body] xml = " + model.body.xml + messages::kOutsideOfFolder + into.string() +
           "; put the file beside the model";
  if (isFile(copy) && other == OtherBody::kKeep)
    return copy.string() + messages::kNotTheBody + body.string() + "; copy that one, or use another folder";
  fs::create_directories(copy.parent_path());
  fs::copy_file(body, copy, fs::copy_options::overwrite_existing);
  return {};
}

}  // namespace darwinop::twin
