// A virtual robot on a pty, the installed commands, and a folder to work in.
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>
#include <map>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include "system/program.hpp"
#include "system/recording.hpp"

#ifndef DARWINOP_BIN
#error "tests/system/CMakeLists.txt names the folder of the programs"
#endif

namespace darwinop {

class Rig : public ::testing::Test {
 protected:
  void SetUp() override {
    std::string pattern = (std::filesystem::temp_directory_path() / "darwinop-XXXXXX").string();
    folder_ = mkdtemp(pattern.data());
    setenv("DARWINOP_RUNTIME_NAME", (folder_ / "runtime").c_str(), 1);
  }
  void TearDown() override {
    virtual_robot_.reset();
    std::filesystem::remove_all(folder_);
  }

  [[nodiscard]] std::string file(const std::string& name) const { return (folder_ / name).string(); }
  [[nodiscard]] static std::string program(const std::string& name) { return DARWINOP_BIN "/" + name; }
  [[nodiscard]] static std::string controller() { return DARWINOP_TEST_CONTROLLER; }

  /// With a fault script and options in the format of docs/virtual-robot.md.
  void startVirtualRobot(const std::string& faults = "", const std::vector<std::string>& options = {}) {
    std::vector<std::string> command{program("darwinop-virtual-robot"), "--link", port()};
    command.insert(command.end(), options.begin(), options.end());
    if (!faults.empty()) {
      std::ofstream{file("faults")} << faults;
      command.insert(command.end(), {"--faults", file("faults")});
    }
    virtual_robot_ = std::make_unique<Program>(command, file("virtual-robot.txt"));
    ASSERT_TRUE(virtual_robot_->says("link:", std::chrono::seconds{10})) << virtual_robot_->output();
  }
  [[nodiscard]] std::string port() const { return file("port"); }

  /// Ends the virtual robot and reads its counters.
  std::map<std::string, double> countersOfVirtualRobot() {
    virtual_robot_->kill(SIGTERM);
    EXPECT_EQ(virtual_robot_->wait(std::chrono::seconds{10}), 0);
    return numbers(virtual_robot_->output(), ": ");
  }

  /// The number before the first "%"; NaN: there is none.
  static double percentIn(const std::string& output) {
    const auto sign = output.find(" %");
    if (sign == std::string::npos) return std::numeric_limits<double>::quiet_NaN();
    return std::strtod(output.c_str() + output.find_last_not_of("0123456789.", sign - 1) + 1, nullptr);
  }

  /// `darwinop run CONTROLLER --robot ROBOT …`, to its end.
  std::string run(const std::string& robot, const std::vector<std::string>& options,
                  const std::vector<std::string>& arguments) {
    std::vector<std::string> command{program("darwinop-run"), "--robot", robot};
    command.insert(command.end(), options.begin(), options.end());
    command.push_back(controller());
    command.insert(command.end(), arguments.begin(), arguments.end());
    Program running{command, file("run.txt")};
    EXPECT_EQ(running.wait(std::chrono::seconds{90}), 0) << running.output();
    return running.output();
  }

  /// The figures of the stable last line.
  static std::map<std::string, double> reportLine(const std::string& output) {
    const auto at = output.rfind("report: ");
    EXPECT_NE(at, std::string::npos) << output;
    return at == std::string::npos ? std::map<std::string, double>{} : numbers(output.substr(at + 8), "=");
  }

  std::filesystem::path folder_;
  std::unique_ptr<Program> virtual_robot_;

 private:
  /// "name<separator>number" wherever it stands, names without the blanks before them.
  static std::map<std::string, double> numbers(const std::string& text, const std::string& separator) {
    std::map<std::string, double> found;
    for (std::size_t at = text.find(separator); at != std::string::npos; at = text.find(separator, at + 1)) {
      std::size_t begin = at;
      while (begin > 0 && (std::isalnum(static_cast<unsigned char>(text[begin - 1])) || text[begin - 1] == '_' ||
                           (separator == ": " && text[begin - 1] == ' ' && begin > 1 && text[begin - 2] != ' ' &&
                            std::isalpha(static_cast<unsigned char>(text[begin - 2])))))
        --begin;
      found[text.substr(begin, at - begin)] = std::strtod(text.c_str() + at + separator.size(), nullptr);
    }
    return found;
  }
};

}  // namespace darwinop
