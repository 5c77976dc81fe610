// `darwinop doctor --json` as a process, on the pty of a virtual robot.
#include <fcntl.h>
#include <gmock/gmock.h>
#include <sys/file.h>
#include <unistd.h>

#include <array>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "hal/cm730/diagnosis/start_policy.hpp"
#include "support/text_of.hpp"
#include "system/rig.hpp"

namespace darwinop {
namespace {

using nlohmann::json;
using std::chrono::seconds;
using testing::Contains;
using testing::HasSubstr;

struct DoctorJson : Rig {
  void SetUp() override {
    Rig::SetUp();
    setenv("DARWINOP_ROBOT_FILE", file("robot.ini").c_str(), 1);
    std::ofstream{file("robot.ini")} << "[Robot]\nperiod_ms = 16\n";
  }
  json examine(int exit_code) {
    Program doctor{{program("darwinop-doctor"), "--robot", port(), "--json"}, file("doctor.json")};
    EXPECT_EQ(doctor.wait(seconds{60}), exit_code) << doctor.output();
    json document = json::parse(doctor.output(), nullptr, false);
    EXPECT_TRUE(document.is_object()) << doctor.output();
    EXPECT_EQ(document["drivable"], exit_code == 0);
    EXPECT_EQ(document["port"], port());
    EXPECT_THAT(document["summary"].get<std::string>(), HasSubstr(" errors: "));
    return document;
  }
  static std::vector<std::string> namesIn(const json& document) {
    std::vector<std::string> names;
    for (const json& fault : document["faults"]) names.push_back(fault["name"]);
    return names;
  }
  static json faultIn(const json& document, const std::string& name) {
    for (const json& fault : document["faults"])
      if (fault["name"] == name) return fault;
    ADD_FAILURE() << name << " is not in " << document["faults"].dump(2);
    return json::object();
  }
};

/// All keys, with the list or object in front of them.
void collectKeys(const json& value, const std::string& before, std::set<std::string>& keys) {
  if (value.is_array())
    for (const json& item : value) collectKeys(item, before + "[]", keys);
  if (!value.is_object()) return;
  for (const auto& [key, item] : value.items()) {
    const std::string path = before.empty() ? key : before + "." + key;
    keys.insert(path);
    collectKeys(item, path, keys);
  }
}

TEST_F(DoctorJson, ABrokenChainHasItsPlaceAndRemedyAndEachKeyIsDocumented) {
  startVirtualRobot("", {"--servo", "AnkleR=missing", "--servo", "FootR=missing"});
  const json document = examine(1);
  EXPECT_EQ(document["examined"], true);
  const json fault = faultIn(document, "chain_broken");
  EXPECT_EQ(fault.value("servos", json::array()), json::array({15}));
  EXPECT_FALSE(fault.value("remedy", std::string{}).empty());
  std::set<std::string> keys;
  collectKeys(document, "", keys);
  EXPECT_GE(keys.size(), 12U);
  const std::string page = textOf(DARWINOP_DOCTOR_PAGE);
  for (const std::string& key : keys) {
    const std::string last = key.substr(key.rfind('.') + 1);
    if (page.find("`" + key + "`") == std::string::npos) {
      EXPECT_THAT(page, HasSubstr(", `" + last + "`")) << key;
    }
  }
}

TEST_F(DoctorJson, AnExchangedPairNamesBothServos) {
  startVirtualRobot("", {"--servo", "ShoulderR=id:13", "--servo", "LegLowerR=id:1"});
  const json fault = faultIn(examine(0), "swapped");
  EXPECT_EQ(fault.value("servos", json::array()), json::array({1}));
  EXPECT_EQ(fault.value("other", 0), 13);
}

TEST_F(DoctorJson, AWarningDoesNotChangeTheExitCode) {
  startVirtualRobot("0 voltage 10.6\n");
  EXPECT_EQ(namesIn(examine(0)).at(0), "supply_low");
}

TEST_F(DoctorJson, AServoThatItsControllerLeftUnderTorqueIsAWarning) {
  startVirtualRobot();
  const auto has_warning = [](const json& document) {
    const std::string_view kind = cm730::kKindTable[static_cast<std::size_t>(cm730::Kind::kUnderTorque)].finding;
    for (const json& finding : document["findings"])
      if (finding.value("kinds", json::array()) == json::array({kind})) return finding["level"] == "warn";
    return false;
  };
  EXPECT_FALSE(has_warning(examine(0)));
  const int controller = ::open(port().c_str(), O_RDWR | O_NOCTTY | O_CLOEXEC);
  const std::array<std::uint8_t, 8> torque_on{0xFF, 0xFF, 20, 4, 3, 24, 1, 0xCB};  // of servo 20
  ASSERT_EQ(::write(controller, torque_on.data(), torque_on.size()), 8);
  ::close(controller);
  EXPECT_TRUE(has_warning(examine(0)));
}

TEST_F(DoctorJson, ABoardWithoutBulkReadIsNamed) {
  startVirtualRobot("", {"--board", "no-bulk-read"});
  EXPECT_THAT(namesIn(examine(1)), Contains("no_bulk_read"));
}

TEST_F(DoctorJson, APortThatAnotherProgramHasLocked) {
  startVirtualRobot();
  const int other = ::open(port().c_str(), O_RDWR | O_NOCTTY | O_CLOEXEC);
  ASSERT_GE(other, 0);
  ASSERT_EQ(::flock(other, LOCK_EX | LOCK_NB), 0);
  const json document = examine(1);
  EXPECT_EQ(namesIn(document), std::vector<std::string>{"other_program"});
  EXPECT_THAT(faultIn(document, "other_program").value("evidence", std::string{}),
              HasSubstr("process " + std::to_string(::getpid()) + " "))
      << "not the virtual robot, which has its pty open as well";
  EXPECT_EQ(document["examined"], false) << "nothing is known of the robot";
  ::close(other);
}

TEST_F(DoctorJson, AMissingPort) {
  EXPECT_EQ(namesIn(examine(1)), std::vector<std::string>{"port_missing"});
}

}  // namespace
}  // namespace darwinop
