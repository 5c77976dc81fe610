// The checked-in body file equals the one generated from the tables.
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <tuple>

#include "support/text_of.hpp"
#include "twin/body/make_xml/body_xml.hpp"
#include "twin/body/make_xml/csv.hpp"

namespace darwinop::twin {
namespace {

TEST(BodyFile, IsWhatTheTablesGive) {
  const std::string models = DARWINOP_MODELS;
  EXPECT_TRUE(textOf(models + "/darwin-op.xml") == bodyXml(models + "/data"))
      << "regenerate it: cmake --build BUILD --target make-body-xml";
}

class BrokenTable : public testing::Test {
 protected:
  void SetUp() override { path_ = testing::TempDir() + "twin_body_table_" + std::to_string(getpid()) + ".csv"; }
  void TearDown() override { std::filesystem::remove(path_); }
  void write(const std::string& text) const { std::ofstream{path_} << text; }
  [[nodiscard]] std::string refusal(auto&& use) const {
    try {
      use(Csv{path_});
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "";
  }
  std::string path_;
};

TEST_F(BrokenTable, IsNamedWithLineAndColumn) {
  write("link,mass\nBody,heavy\n");
  EXPECT_EQ(refusal([](const Csv& csv) { std::ignore = csv.number(0, "mass"); }),
            path_ + ", line 2, mass: \"heavy\" is not a number");
  EXPECT_EQ(refusal([](const Csv& csv) { std::ignore = csv.text(0, "colour"); }), path_ + ": no column \"colour\"");
  write("link,mass\nBody,1\nHead\n");
  EXPECT_EQ(refusal([](const Csv&) {}), path_ + ", line 3: 1 cells; the header has 2");
  std::filesystem::remove(path_);
  EXPECT_EQ(refusal([](const Csv&) {}), path_ + ": " + kNoHeaderLine);
}

}  // namespace
}  // namespace darwinop::twin
