// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <bit>
#include <clocale>
#include <cmath>
#include <limits>
#include <random>

#include "core/formats/number.h"

namespace mesecina {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

TEST(Number, IsWrittenAsShortlyAsPossible) {
  EXPECT_EQ(format_number(0.1), "0.1");
  EXPECT_EQ(format_number(1), "1");
  EXPECT_EQ(format_number(-2.5), "-2.5");
  EXPECT_EQ(format_number(1e300), "1e+300");
  EXPECT_EQ(format_number(infinity), "inf");
  EXPECT_EQ(format_number(-infinity), "-inf");
  EXPECT_EQ(format_number(std::nan("")), "nan");
  EXPECT_EQ(format_number(-std::nan("")), "nan");
}

TEST(Number, AppendsToWhatIsThere) {
  std::string text = "x=";
  append_number(text, 0.25);
  EXPECT_EQ(text, "x=0.25");
}

TEST(Number, ReadsBackEveryDouble) {
  std::mt19937_64 random(1);
  for (int i = 0; i < 100000; ++i) {
    const double value = std::bit_cast<double>(random());
    if (std::isnan(value)) continue;
    const auto read = parse_number(format_number(value));
    ASSERT_TRUE(read) << format_number(value);
    ASSERT_EQ(std::bit_cast<std::uint64_t>(*read), std::bit_cast<std::uint64_t>(value));
  }
}

TEST(Number, AcceptsSignsExponentsAndInfinities) {
  EXPECT_EQ(parse_number("+1.5"), 1.5);
  EXPECT_EQ(parse_number("-.5e1"), -5);
  EXPECT_EQ(parse_number("5."), 5);
  EXPECT_EQ(parse_number("inf"), infinity);
  EXPECT_EQ(parse_number("-inf"), -infinity);
}

TEST(Number, RefusesWhatIsNotWhollyANumber) {
  for (const char* text : {"", "+", "-", "+-1", "1,5", "1 ", " 1", "1x", "0x10", "nan", "1e", "--1", "1e999", "."})
    EXPECT_FALSE(parse_number(text)) << "'" << text << "'";
}

TEST(Number, DoesNotDependOnTheLocale) {
  const std::string before = std::setlocale(LC_ALL, nullptr);
  for (const char* locale : {"de_DE.UTF-8", "fr_FR.UTF-8"}) std::setlocale(LC_ALL, locale);
  EXPECT_EQ(format_number(0.5), "0.5");
  EXPECT_EQ(parse_number("0.5"), 0.5);
  std::setlocale(LC_ALL, before.c_str());
}

}  // namespace
}  // namespace mesecina
