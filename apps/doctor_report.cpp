#include "doctor_report.hpp"

#include <cstdio>
#include <utility>

#include "core/json/json_text.hpp"

namespace darwinop::app {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::array<const char*, 3> kLevelNames{"ok", "warn", "fail"};

// docs/doctor.md lists the keys. What does not apply is absent.
Json jsonOf(const cm730::NamedFault& fault) {
  Json json{{"name", cm730::row(fault.fault).name}, {"what", fault.what}, {"remedy", fault.remedy}};
  if (!fault.evidence.empty()) json["evidence"] = fault.evidence;
  forEachJoint(fault.joints, [&](std::size_t i) { json["servos"].push_back(servoId(i)); });
  if (fault.other) json["other"] = row(*fault.other).id;
  return json;
}

Json jsonOf(const cm730::Finding& finding, const std::string& part) {
  Json json{{"part", part}, {"level", kLevelNames[static_cast<std::size_t>(finding.level)]}, {"what", finding.what}};
  if (!finding.remedy.empty()) json["remedy"] = finding.remedy;
  if (finding.joint) json["servo"] = row(*finding.joint).id;
  for (std::size_t i = 0; i < cm730::kKinds; ++i)
    if (finding.kinds[i]) json["kinds"].push_back(cm730::kKindTable[i].finding);
  return json;
}

}  // namespace

void DoctorReport::begin(std::string part) {
  part_ = std::move(part);
  examined_ = examined_ || part_ == kRobotPart;
  if (!json_) std::printf("%s\n", part_.c_str());
}

void DoctorReport::add(const cm730::Findings& findings) {
  for (const cm730::Finding& finding : findings) {
    if (!json_) std::fputs(cm730::toText(finding).c_str(), stdout);
    ++count_[static_cast<std::size_t>(finding.level)];
    findings_.push_back(finding);
    parts_.push_back(part_);
  }
  std::fflush(stdout);
}

int DoctorReport::finish(const std::string& port, const std::vector<cm730::NamedFault>& faults) {
  if (json_) {
    std::printf("%s\n", document(port, faults).c_str());
    return drivable() ? 0 : 1;
  }
  if (!faults.empty()) std::printf("faults, the most probable first\n");
  for (const cm730::NamedFault& fault : faults) std::fputs(cm730::toText(fault).c_str(), stdout);
  std::printf("%s\n", summary().c_str());
  return drivable() ? 0 : 1;
}

std::string DoctorReport::summary() const {
  std::string text = std::to_string(count(cm730::Level::kOk)) + " ok, " +
                     std::to_string(count(cm730::Level::kWarning)) + " warnings, " +
                     std::to_string(count(cm730::Level::kError)) + " errors: the robot ";
  if (!examined_) return text + "was not examined";
  return text + (drivable() ? "can be driven" : "cannot be driven");
}

std::string DoctorReport::document(const std::string& port, const std::vector<cm730::NamedFault>& faults) const {
  Json json{{"drivable", drivable()},
            {"examined", examined_},
            {"summary", summary()},
            {"port", port},
            {"faults", Json::array()}};
  for (const cm730::NamedFault& fault : faults) json["faults"].push_back(jsonOf(fault));
  json["findings"] = Json::array();
  for (std::size_t i = 0; i < findings_.size(); ++i) json["findings"].push_back(jsonOf(findings_[i], parts_[i]));
  return jsonText(json, 2);
}

}  // namespace darwinop::app
