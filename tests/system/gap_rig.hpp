// Commands of darwinop-gap on recordings of a whole robot, which is a twin.
#pragma once

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "support/text_of.hpp"
#include "system/rig.hpp"

namespace darwinop {

class GapRig : public Rig {
 protected:
  using json = nlohmann::json;
  using seconds = std::chrono::seconds;

  /// To its end; the status.
  int gap(const std::vector<std::string>& words, seconds at_most) {
    std::vector<std::string> all{program("darwinop-gap")};
    all.insert(all.end(), words.begin(), words.end());
    Program running{all, file("command.txt")};
    const auto status = running.wait(at_most);
    said_ = running.output();
    return status.value_or(-1);
  }

  /// The twin with the shipped model, these keys of [imu] and these effects.
  std::string robotWith(const std::string& imu, const std::string& effects) {
    std::string text = textOf(DARWINOP_USUAL_MODEL);
    text.insert(text.find("gyro_range"), imu);
    std::ofstream{file("hidden.ini")} << text << "\n" << effects;
    return "twin:" + file("hidden.ini");
  }

  void record(const std::string& robot) {
    ASSERT_EQ(gap({"record", "--robot", robot, "--out", file("case")}, seconds{120}), 0) << said_;
  }

  /// A case of one recording, upright, of a twin; its head says that it is of `robot`.
  void recordUpright(const std::string& robot) {
    std::filesystem::create_directories(file("case"));
    Program running{{program("darwinop-experiment"), "run", "body_chirp", "--robot", "twin", "--yes", "--record",
                     file("case/up.csv")},
                    file("command.txt")};
    ASSERT_EQ(running.wait(seconds{60}), 0) << running.output();
    std::string text = textOf(file("case/up.csv"));
    const std::string key = "# model: ";
    const std::size_t at = text.find(key) + key.size();
    std::ofstream{file("case/up.csv")} << text.replace(at, text.find('\n', at) - at, robot);
    std::ofstream{file("case/case.json")} << R"({"case": "case", "family": "body", "model": "darwin-op",
      "trust": {}, "logs": [{"file": "up.csv", "role": "fit", "setup": "stand_clamped", "up": [0, 1, 0],
      "from_s": 7.3, "battery_V": 11.8}]})";  // the twin has been in the pose for 1.4 s
  }

  /// Signals that diverge from the model.
  std::vector<std::string> openSignals(const std::string& model) {
    EXPECT_EQ(gap({"locate", file("case"), "--json", "--model", model}, seconds{200}), 0) << said_;
    const json table = json::parse(said_.substr(said_.find('{')));
    EXPECT_EQ(table["rows"].size(), 66u);
    std::vector<std::string> open;
    for (const json& row : table["rows"])
      if (row["open"]) open.push_back(row["signal"]);
    return open;
  }

  std::string said_;  // by the last command
};

}  // namespace darwinop
