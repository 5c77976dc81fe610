// Raw registers: every count of every encoding, and the columns of a case that declare one.
#include "gap/case/encodings.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <set>

#include "core/units.hpp"
#include "gap/case/case_texts.hpp"
#include "gap/case/messages.hpp"

namespace darwinop::gap {
namespace {

using testing::HasSubstr;

double decoded(std::string_view name, double count) {
  const Encoding* const found = findEncoding(name);
  return found == nullptr ? std::nan("") : found->decode(count);
}

/// The register of a signed number of counts, as a servo sends it.
double registerOf(CountSign sign, int counts) {
  if (counts >= 0 || sign == CountSign::kUnsigned) return counts;
  switch (sign) {
    case CountSign::kBit10:
      return 1'024 - counts;
    case CountSign::kBit15:
      return 32'768 - counts;
    default:
      return 65'536 + counts;
  }
}

TEST(Encodings, EveryCountGivesItsValueBack) {
  for (const Encoding& encoding : encodings()) {
    const int most = encoding.sign == CountSign::kBit10 ? 1'023 : 32'767;
    const int least = encoding.sign == CountSign::kUnsigned ? 0 : -most;
    for (int counts = least; counts <= most; ++counts) {
      const double value = encoding.decode(registerOf(encoding.sign, counts));
      ASSERT_NEAR(value / encoding.scale + encoding.zero, counts, 1e-6) << encoding.name;
      if (counts < 0) {
        ASSERT_EQ(encoding.decode(counts), value) << encoding.name << ": the sign was applied before";
      }
    }
  }
}

TEST(Encodings, NumbersThatARegisterCannotHoldHaveNoValue) {
  for (const Encoding& encoding : encodings())
    for (const double count : {0.5, -32'769.0, 65'536.0, 1e300, std::nan(""), HUGE_VAL})
      EXPECT_TRUE(std::isnan(encoding.decode(count))) << encoding.name << count;
  EXPECT_TRUE(std::isnan(decoded("load_bit10", 2'048)));
  EXPECT_TRUE(std::isnan(decoded("volt_0.1V", -1)));
}

TEST(Encodings, AgreeWithTheManuals) {
  EXPECT_NEAR(decoded("load_bit10", 1'024 + 250), -0.25, 1e-12);
  EXPECT_NEAR(decoded("load_int16", 65'286), -0.25, 1e-12);
  EXPECT_NEAR(decoded("current_bit15_6.5mA", 100), 0.65, 1e-12);
  EXPECT_NEAR(decoded("current_int16_2.69mA", 65'436), -0.269, 1e-12);
  EXPECT_NEAR(decoded("speed_bit10_0.111rpm", 1'000) * 60 / (2 * kPi), 111, 1e-9);
  EXPECT_NEAR(decoded("speed_bit15_0.732rpm", 100) * 60 / (2 * kPi), 73.2, 1e-9);
  // 50 steps/s are 0.732 rpm.
  EXPECT_NEAR(decoded("speed_bit15_50steps", 100) / decoded("speed_bit15_0.732rpm", 100), 1, 1e-3);
  EXPECT_EQ(decoded("position_4096", 2'048), 0);
}

TEST(Encodings, NamesAreUnique) {
  std::set<std::string_view> names;
  for (const Encoding& encoding : encodings()) EXPECT_TRUE(names.insert(encoding.name).second) << encoding.name;
  EXPECT_EQ(findEncoding("load_bit9"), nullptr);
}

/// A case whose load is the raw register.
CaseTexts rawLoads(const std::string& encodings) {
  std::vector<CsvRow> rows = sineRows();
  for (CsvRow& row : rows) row.load = row.load < 0 ? 1'024 - std::round(row.load * 10) : std::round(row.load * 10);
  CaseTexts texts = CaseTexts{}.with("\"family\": \"pend\"", "\"encodings\": {" + encodings + "}");
  texts.logs["fit_1.csv"] = csvOf(rows, "t_s,goal_rad,torque_on,pos_rad,speed_rad_s,load_raw,volt_V,temp_C");
  return texts;
}

TEST(Encodings, ARawColumnIsReadByItsDeclaredEncoding) {
  const Case raw = rawLoads("\"load_raw\": \"load_bit10\"").read(), plain = CaseTexts{}.read();
  EXPECT_TRUE(raw.logs[0].masked.empty());
  for (std::size_t row = 0; row < raw.logs[0].rows(); ++row)
    ASSERT_NEAR(raw.logs[0].load[row], plain.logs[0].load[row], 1e-9) << row;
}

TEST(Encodings, WhatIsMissingOrWrongIsRefused) {
  EXPECT_THAT(rawLoads("").error(), HasSubstr(messages::kNoEncoding));
  EXPECT_THAT(rawLoads("\"load_raw\": \"load_bit9\"").error(), HasSubstr("load_bit10"));
  EXPECT_THAT(rawLoads("\"load_raw\": \"volt_0.1V\"").error(), HasSubstr(messages::kOtherColumn));
}

}  // namespace
}  // namespace darwinop::gap
