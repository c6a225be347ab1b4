#include "cli/quantity.h"

#include <gtest/gtest.h>

#include <limits>
#include <string>

namespace unstep::cli {
namespace {

using Unit = Quantity::Unit;

TEST(Quantity, BareNumberIsGridUnits) {
  const Result<Quantity> quantity = parse_quantity("12.5");
  ASSERT_TRUE(quantity);
  EXPECT_EQ(*quantity, (Quantity{12.5, Unit::grid}));
}

TEST(Quantity, UnitsAreNamedWithOrWithoutASpace) {
  EXPECT_EQ(*parse_quantity("3px"), (Quantity{3, Unit::grid}));
  EXPECT_EQ(*parse_quantity("0.5mm"), (Quantity{0.5, Unit::millimetre}));
  EXPECT_EQ(*parse_quantity("0.5 mm"), (Quantity{0.5, Unit::millimetre}));
  EXPECT_EQ(*parse_quantity("2in"), (Quantity{2, Unit::inch}));
}

TEST(Quantity, EverythingElseIsRefused) {
  for (const char* text : {"", "mm", "-1", "-0", "1e3", "1,5", "1cm", "1 ",
                           "1  mm", "1mm ", "inf", "nan", "0x10", "+1", " 1"}) {
    const Result<Quantity> quantity = parse_quantity(text);
    ASSERT_FALSE(quantity) << text;
    EXPECT_EQ(quantity.error().code, ErrorCode::invalid_argument) << text;
  }
}

TEST(Quantity, BecomesGridUnitsByTheResolution) {
  const Rational dpi{300, 1};
  EXPECT_DOUBLE_EQ(
      *to_grid_units({25.4, Unit::millimetre}, dpi, Resolution::Unit::inch),
      300);
  EXPECT_DOUBLE_EQ(
      *to_grid_units({0.5, Unit::inch}, dpi, Resolution::Unit::inch), 150);
  EXPECT_DOUBLE_EQ(*to_grid_units({10, Unit::millimetre}, {236, 2},
                                  Resolution::Unit::centimetre),
                   118);
  EXPECT_DOUBLE_EQ(
      *to_grid_units({1, Unit::inch}, {10000, 1}, Resolution::Unit::metre),
      254);
}

TEST(Quantity, GridUnitsNeedNoResolution) {
  EXPECT_DOUBLE_EQ(
      *to_grid_units({7, Unit::grid}, {0, 1}, Resolution::Unit::none), 7);
  EXPECT_FALSE(to_grid_units({7, Unit::inch}, {0, 1}, Resolution::Unit::inch));
  EXPECT_FALSE(
      to_grid_units({7, Unit::millimetre}, {1, 1}, Resolution::Unit::none));
}

TEST(Count, SuffixesScale) {
  EXPECT_EQ(*parse_count("0"), 0U);
  EXPECT_EQ(*parse_count("12"), 12U);
  EXPECT_EQ(*parse_count("3K"), 3'000U);
  EXPECT_EQ(*parse_count("3Ki"), 3'072U);
  EXPECT_EQ(*parse_count("5M"), 5'000'000U);
  EXPECT_EQ(*parse_count("5Mi"), 5'242'880U);
  EXPECT_EQ(*parse_count("2G"), 2'000'000'000U);
  EXPECT_EQ(*parse_count("2Gi"), 2'147'483'648U);
  EXPECT_EQ(*parse_count("18446744073709551615"),
            std::numeric_limits<std::uint64_t>::max());
}

TEST(Count, OverflowIsOutOfRange) {
  for (const char* text :
       {"18446744073709551616", "18446744073709551615K", "17179869184Gi"}) {
    const Result<std::uint64_t> count = parse_count(text);
    ASSERT_FALSE(count) << text;
    EXPECT_EQ(count.error().code, ErrorCode::out_of_range) << text;
  }
}

TEST(Count, EverythingElseIsRefused) {
  for (const char* text : {"", "K", "-1", "1.5", "1k", "1 K", "1KiB", "+1"}) {
    const Result<std::uint64_t> count = parse_count(text);
    ASSERT_FALSE(count) << text;
    EXPECT_EQ(count.error().code, ErrorCode::invalid_argument) << text;
  }
}

TEST(Quantity, WaysHaveASign) {
  EXPECT_EQ(*parse_signed_quantity("-3px"), (Quantity{-3, Unit::grid}));
  EXPECT_EQ(*parse_signed_quantity("+0.5mm"),
            (Quantity{0.5, Unit::millimetre}));
  EXPECT_EQ(*parse_signed_quantity("12"), (Quantity{12, Unit::grid}));
  for (const char* text : {"", "-", "--3", "+-3", "- 3", "-inf", "-3e2"}) {
    EXPECT_FALSE(parse_signed_quantity(text)) << text;
  }
}

TEST(Quantity, TimesAreSeconds) {
  EXPECT_EQ(*parse_seconds("0.25"), 0.25);
  EXPECT_EQ(*parse_seconds("2s"), 2);
  EXPECT_EQ(*parse_seconds("500 ms"), 0.5);
  for (const char* text : {"", "-1", "1e3", "3px", "3 ", "nan"}) {
    EXPECT_FALSE(parse_seconds(text)) << text;
  }
}

}  // namespace
}  // namespace unstep::cli
