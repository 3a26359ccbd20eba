#include "verification/scene/units.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>
#include <cstdio>

#include <fmt/format.h>

namespace wetfront::verification {
namespace {

double si(const std::string& text, const std::string& unit) {
  const auto read = read_quantity(text, unit);
  if (const Complaint* complaint = std::get_if<Complaint>(&read)) {
    ADD_FAILURE() << complaint->text();
    return std::nan("");
  }
  return std::get<double>(read);
}

std::string complaint(const std::string& text, const std::string& unit) {
  const auto read = read_quantity(text, unit);
  return std::holds_alternative<Complaint>(read) ? std::get<Complaint>(read).text() : "no complaint";
}

TEST(Units, EverydayOnes) {
  EXPECT_DOUBLE_EQ(si("100 mm/h", "m/s"), 0.1 / 3600);
  EXPECT_DOUBLE_EQ(si("4.35 kPa", "Pa"), 4350);
  EXPECT_DOUBLE_EQ(si("3e-11 m2", "m2"), 3e-11);
  EXPECT_DOUBLE_EQ(si("1e-6 kPa s", "Pa s"), 1e-3);
  EXPECT_DOUBLE_EQ(si("30 deg", "rad"), std::acos(-1.0) / 6);
  EXPECT_DOUBLE_EQ(si("0.5 h", "s"), 1800);
  EXPECT_DOUBLE_EQ(si("25 %", "1"), 0.25);
  EXPECT_DOUBLE_EQ(si("1e-8", "1"), 1e-8);
  EXPECT_DOUBLE_EQ(si("+1.2m", "m"), 1.2);
  EXPECT_DOUBLE_EQ(si("-9.81 m/s^2", "m/s2"), -9.81);
  EXPECT_DOUBLE_EQ(si("2.69 g/cm3", "kg/m3"), 2690);
}

TEST(Units, HeadsOfWaterAndReciprocalLengths) {
  const auto pressure = [](const std::string& text, double unit_weight) {
    const auto read = read_quantity(text, "Pa or m", unit_weight);
    return std::holds_alternative<double>(read) ? std::get<double>(read) : std::nan("");
  };
  EXPECT_DOUBLE_EQ(pressure("-50 cm", 9810), -4905);
  EXPECT_DOUBLE_EQ(pressure("-4.905 kPa", 9810), -4905);
  EXPECT_TRUE(std::isnan(pressure("-50 cm", 0)));  // nothing weighs water here
  EXPECT_EQ(pressure("2 kPa", 0), 2000);
  EXPECT_TRUE(std::isnan(pressure("2 s", 9810)));
  EXPECT_DOUBLE_EQ(si("0.02 1/cm", "1/m"), 2);
  EXPECT_DOUBLE_EQ(si("2 m-1", "1/m"), 2);
  EXPECT_THAT(complaint("2 m", "1/m"), testing::HasSubstr("is a length"));  // udunits inverts it
  EXPECT_THAT(complaint("2 1/m", "m"), testing::HasSubstr("is a reciprocal length"));
}

TEST(Units, ReciprocalsShiftedZerosAndAnglesAreNotConverted) {
  EXPECT_THAT(complaint("2 s/m", "m/s"), testing::HasSubstr("is of another kind"));  // udunits inverts it
  EXPECT_THAT(complaint("2 m @ 1", "m"), testing::HasSubstr("unknown unit"));
  EXPECT_THAT(complaint("2 3 m", "m"), testing::HasSubstr("unknown unit"));
  EXPECT_THAT(complaint("30 %", "rad"), testing::HasSubstr("is a pure number"));
  EXPECT_THAT(complaint("30 deg", "1"), testing::HasSubstr("is an angle"));
}

TEST(Units, NothingLeaksToStderr) {
  testing::internal::CaptureStderr();
  for (const char* text : {"1 furlongs per fortnight squared", "1 kpa", "1 (", "1 m^^2", "1 \xff", "1 m/", "@", ""})
    EXPECT_NE(complaint(text, "Pa"), "no complaint") << text;
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST(Units, RoundTrip) {
  struct Pair {
    std::string from, to;
    double factor;
  };
  const std::vector<Pair> pairs = {
      {"kPa", "Pa", 1e3}, {"mm", "m", 1e-3}, {"h", "s", 3600}, {"%", "1", 0.01}, {"g/cm3", "kg/m3", 1e3}};
  EXPECT_TRUE(rc::check("the number written is the number read, times the factor of its unit", [&] {
    const Pair pair = *rc::gen::elementOf(pairs);
    const double number = *rc::gen::suchThat(rc::gen::arbitrary<double>(),
                                             [](double x) { return std::isfinite(x) && std::abs(x) < 1e290; });
    const double read = si(fmt::format("{} {}", number, pair.from), pair.to);
    RC_ASSERT(std::abs(read - number * pair.factor) <= 4e-16 * std::abs(number * pair.factor));
  }));
}

}  // namespace
}  // namespace wetfront::verification
