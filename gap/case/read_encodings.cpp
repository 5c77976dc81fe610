// `encodings` of a case.json: {"load_raw": "load_bit10"}.
#include "core/text/nearest.hpp"
#include "gap/case/messages.hpp"
#include "gap/case/parts.hpp"

namespace darwinop::gap {

Encodings readEncodings(Fields& top) {
  Encodings found;
  if (!top.has("encodings")) return found;
  Fields declared = top.object("encodings");
  std::vector<std::string_view> names;
  for (const Encoding& encoding : encodings()) names.push_back(encoding.name);
  for (const std::string& column : declared.keys()) {
    const std::string name = declared.text(column);
    const Encoding* const encoding = findEncoding(name);
    if (encoding == nullptr)
      declared.fail(column, std::string{messages::kNoEncodingOf} + "; " + text::suggestion(name, names));
    if (column != std::string{encoding->column} + "_raw")
      declared.fail(column,
                    std::string{messages::kOtherColumn} + "; it is for " + std::string{encoding->column} + "_raw");
    found[column] = encoding;
  }
  return found;
}

}  // namespace darwinop::gap
