// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/formats/temporary_folder.h"

namespace mesecina {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

const std::vector<Point_2> two_points = {{1, 2}, {-3.5, 0.1}};
const std::vector<Disk_2> two_disks = {{{1, 2}, 3}, {{-3.5, 0.1}, 0.25}};

class Tables : public testing::Test {
 protected:
  void expect_points(std::string_view name, std::string_view text) const {
    const File_contents contents = folder_.read(name, text);
    ASSERT_EQ(contents.inputs.ids(), std::vector<std::string>{"points"}) << name << ": " << text;
    EXPECT_EQ(*contents.inputs.get(points_input), two_points) << name << ": " << text;
    EXPECT_TRUE(contents.warnings.empty());
  }
  void expect_disks(std::string_view name, std::string_view text) const {
    const File_contents contents = folder_.read(name, text);
    ASSERT_EQ(contents.inputs.ids(), std::vector<std::string>{"disks"}) << name << ": " << text;
    EXPECT_EQ(*contents.inputs.get(disks_input), two_disks) << name << ": " << text;
    EXPECT_TRUE(contents.warnings.empty());
  }
  /// The message has the line, what was expected and what was found.
  void expect_error(std::string_view name, std::string_view text, int line, std::string_view expected,
                    std::string_view found) const {
    std::string start(name);
    if (line != 0) start.append(":").append(std::to_string(line));
    start += ": expected ";
    EXPECT_THAT(folder_.error(name, text), AllOf(StartsWith(start), HasSubstr(std::string(expected)),
                                                 HasSubstr(std::string(", found ").append(found)), HasSubstr("; ")))
        << text;
  }

  Temporary_folder folder_;
};

TEST_F(Tables, PointsWithEverySeparator) {
  for (const char* name : {"a.xy", "a.xyz", "a.csv", "a.txt", "a.XY"}) {
    expect_points(name, "1 2\n-3.5 0.1\n");
    expect_points(name, "1\t2\n-3.5\t\t0.1");
    expect_points(name, "  1,2\n-3.5 , .1\n\n");
    expect_points(name, "1;2\r\n-3.5; 1e-1\r\n");
  }
}

TEST_F(Tables, CommentsHeaderAndByteOrderMark) {
  expect_points("a.csv", "\xEF\xBB\xBFx,y\n1,2\n-3.5,0.1\n");
  expect_points("a.csv", "\"x\";\"y\"\r\n1;2\r\n-3.5;0.1\r\n");
  expect_points("a.xy", "# made by hand\n// again\n\n1 2 # first\n   \n-3.5 0.1// second\n#end");
  expect_points("a.txt", "longitude latitude\n1 2\n-3.5 0.1\n");
  expect_disks("a.csv", "x,y,r\n1,2,3\n-3.5,0.1,.25\n");
}

TEST_F(Tables, ThreeColumnsAreDisks) {
  for (const char* name : {"a.xy", "a.xyz", "a.csv", "a.txt"}) expect_disks(name, "1 2 3\n-3.5 0.1 0.25\n");
}

TEST_F(Tables, RadiiOfZeroAreAllowed) {
  const File_contents contents = folder_.read("a.csv", "1,2,0\n3,4,1\n");
  EXPECT_EQ(*contents.inputs.get(disks_input), (std::vector<Disk_2>{{{1, 2}, 0}, {{3, 4}, 1}}));
}

TEST_F(Tables, HeightsOfZeroInXyzArePointsOfThePlane) {
  expect_points("a.xyz", "1 2 0\n-3.5 0.1 0.0\n");
  expect_points("a.xyz", "x y z\n1 2 0\n-3.5 0.1 -0\n");
}

TEST_F(Tables, HeightsInXyzAreNoRadii) {
  expect_error("a.xyz", "1 2 3\n\n1 2 -3\n", 3, "of only positive radii", "'-3'");
  expect_error("a.xyz", "1 2 3\n1 2 0\n", 2, "of only positive radii", "'0'");
  expect_error("a.xyz", "0 0 0\n1 2 5\n", 1, "of only positive radii", "'0'");
}

TEST_F(Tables, NamesOfOtherColumnsAreRefused) {
  expect_error("a.csv", "id,x,y\n1,2,3\n", 1, "the columns x y or x y radius", "'id,x,y'");
  expect_error("a.csv", "y,x\n1,2\n", 1, "the columns x y or x y radius", "'y,x'");
  expect_error("a.csv", "x,y,z\n1,2,3\n", 1, "the columns x y or x y radius", "'x,y,z'");
  expect_error("a.csv", "element,kind,id,x0\n", 1, "the columns x y or x y radius", "'element,kind,id,x0'");
}

TEST_F(Tables, NumbersOfColumns) {
  expect_error("a.xy", "1\n", 1, "2 columns x y or 3 columns x y radius", "1 column in '1'");
  expect_error("a.xyz", "1 2 3 0 0 1\n", 1, "2 columns", "6 columns");
  expect_error("a.xy", "1 2\n3 4\n5 6 7\n", 3, "2 columns as on the lines before", "3 columns in '5 6 7'");
  expect_error("a.csv", "x,y,r\n1,2\n", 2, "3 columns", "2 columns in '1,2'");
}

TEST_F(Tables, Numbers) {
  expect_error("a.xy", "1 2\n3 four\n", 2, "a finite number for y", "'four'");
  expect_error("a.xy", "nan 2\n", 1, "a finite number for x", "'nan'");
  expect_error("a.xy", "1 inf\n", 1, "a finite number for y", "'inf'");
  expect_error("a.csv", "1,2,inf\n", 1, "a finite number for a radius", "'inf'");
  expect_error("a.csv", "1,2,-1e-9\n", 1, "a radius of at least 0", "'-1e-09'");
  expect_error("a.csv", "1,2\n1,\n", 2, "a finite number for y", "nothing");
  expect_error("a.csv", "1,2,3\n1,,3\n", 2, "a finite number for y", "nothing");
  expect_error("a.xy", "1e999 2\n", 1, "a finite number for x", "'1e999'");
}

TEST_F(Tables, GarbageIsQuotedShortly) {
  using namespace std::string_view_literals;
  expect_error("a.xy", "1 2\n\0\1\2"sv, 2, "text", "a zero byte");
  expect_error("a.xy", "\xFF\xFE\x31\x00"sv, 1, "UTF-8 text", "UTF-16");
  expect_error("a.xy", "\x01\xC3\x28 \x7F\xB2\n", 1, "a finite number for x",
               "'?"
               "?('");
  const std::string long_line = "1 " + std::string(5000, '7') + "x\n";
  EXPECT_LT(folder_.error("a.xy", long_line).size(), 200u);
  EXPECT_THAT(folder_.error("a.xy", long_line), HasSubstr(std::string(40, '7') + "'..."));
}

TEST_F(Tables, FilesWithoutNumbers) {
  expect_error("a.xy", "", 0, "data", "an empty file");
  expect_error("a.csv", " \r\n\n\t", 0, "data", "an empty file");
  expect_error("a.xy", "# only\n# comments\n", 2, "lines x y", "no numbers");
  expect_error("a.txt", "hello world\n", 1, "lines x y", "no numbers");
}

TEST_F(Tables, AHeaderAloneIsAnEmptySet) {
  EXPECT_TRUE(folder_.read("a.xy", "x y\n").inputs.get(points_input)->empty());
  EXPECT_TRUE(folder_.read("a.csv", "x,y,r\n").inputs.get(disks_input)->empty());
}

TEST_F(Tables, PoffAndWpoff) {
  expect_points("a.poff", "POFF 2 0 0\n1 2\n-3.5 0.1\n");
  expect_points("a.poff", "# points\nPOFF\n2 0 0\r\n\n1 2\r\n-3.5 0.1 # last");
  expect_disks("a.wpoff", "WPOFF 2 0 0\n1 2 3\n-3.5 0.1 0.25\n");
  expect_disks("a.poff", "WPOFF 2 0 0\n1 2 3\n-3.5 0.1 0.25\n");
  EXPECT_TRUE(folder_.read("a.poff", "POFF 0 0 0\n").inputs.get(points_input)->empty());
}

TEST_F(Tables, PoffHeaders) {
  expect_error("a.poff", "OFF 2 0 0\n1 2\n", 1, "'POFF n 0 0' or 'WPOFF n 0 0'", "'OFF 2 0 0'");
  expect_error("a.poff", "POFF\n", 1, "'POFF n 0 0'", "nothing");
  expect_error("a.poff", "POFF two 0 0\n1 2\n", 1, "'POFF n 0 0'", "'POFF two 0 0'");
  expect_error("a.poff", "POFF -2 0 0\n1 2\n", 1, "'POFF n 0 0'", "'POFF -2 0 0'");
  expect_error("a.poff", "POFF 1 1 0\n1 2\n", 1, "'POFF n 0 0'", "'POFF 1 1 0'");
  expect_error("a.wpoff", "WPOFF 99999999999999999999 0 0\n", 1, "'WPOFF n 0 0'", "'WPOFF 9999");
}

TEST_F(Tables, PoffCountsWhatIsThere) {
  expect_error("a.poff", "POFF 100000000 0 0\n1 2\n3 4\n5 6\n", 4, "100000000 points", "3");
  expect_error("a.wpoff", "WPOFF 100000000 0 0\n1 2 1\n", 2, "100000000 disks", "1");
  expect_error("a.poff", "POFF 1 0 0\n1 2\n3 4\n", 3, "1 points", "2");
}

TEST_F(Tables, PoffLines) {
  expect_error("a.poff", "POFF 2 0 0\n1 2\n3\n", 3, "2 columns x y", "1 column in '3'");
  expect_error("a.wpoff", "WPOFF 1 0 0\n1 2\n", 2, "3 columns x y radius", "2 columns in '1 2'");
  expect_error("a.wpoff", "WPOFF 1 0 0\n1 2 -1\n", 2, "a radius of at least 0", "'-1'");
  expect_error("a.poff", "POFF 1 0 0\n1 nan\n", 2, "a finite number for y", "'nan'");
}

}  // namespace
}  // namespace mesecina
