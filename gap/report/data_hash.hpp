// Hash of the data of a case, so that two reports can be compared.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "gap/case/case.hpp"

namespace darwinop::gap {

/// Its key in report.json.
inline constexpr const char* kDataHash = "data_sha256";

/// FIPS 180-4, in 64 hexadecimal digits.
std::string sha256(std::string_view data);

/// Of case.json and the logs behind each other, in the order of the case:
/// `cd CASE && cat case.json fit_1.csv … | sha256sum` gives the same. Empty: a case that lies in no folder.
std::string dataHash(const Case& given);
/// The same of these files of a folder.
std::string dataHash(const std::string& folder, const std::vector<std::string>& files);
/// That command, to be run in the folder of the case.
std::string hashCommand(const Case& given);

}  // namespace darwinop::gap
