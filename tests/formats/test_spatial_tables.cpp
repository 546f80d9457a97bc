// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/formats/temporary_folder.h"

namespace mesecina {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

const std::vector<Point_3> two_points = {{1, 2, 3}, {-3.5, 0.1, 0}};
const std::vector<Ball_3> two_balls = {{{1, 2, 3}, 4}, {{-3.5, 0.1, 0}, 0.25}};

class Spatial_tables : public testing::Test {
 protected:
  File_contents expect_points(std::string_view name, std::string_view text) const {
    File_contents contents = folder_.read(name, text);
    EXPECT_EQ(contents.inputs.ids(), std::vector<std::string>{"cloud"}) << name << ": " << text;
    EXPECT_EQ(*contents.inputs.get(cloud_input), two_points) << name << ": " << text;
    return contents;
  }
  File_contents expect_balls(std::string_view name, std::string_view text) const {
    File_contents contents = folder_.read(name, text);
    EXPECT_EQ(contents.inputs.ids(), std::vector<std::string>{"balls"}) << name << ": " << text;
    EXPECT_EQ(*contents.inputs.get(balls_input), two_balls) << name << ": " << text;
    return contents;
  }
  void expect_error(std::string_view name, std::string_view text, int line, std::string_view expected,
                    std::string_view found) const {
    std::string start(name);
    if (line != 0) start.append(":").append(std::to_string(line));
    start += ": expected ";
    EXPECT_THAT(folder_.error(name, text), AllOf(StartsWith(start), HasSubstr(std::string(expected)),
                                                 HasSubstr(std::string(", found ").append(found)), HasSubstr("; ")))
        << text;
  }

  Temporary_folder folder_{spatial_formats()};
};

TEST_F(Spatial_tables, PointsWithEverySeparator) {
  for (const char* name : {"a.xyz", "a.pts", "a.pwn", "a.csv", "a.txt", "a.XYZ"}) {
    for (const char* text :
         {"1 2 3\n-3.5 0.1 0\n", "1\t2\t3\n-3.5\t\t0.1 0", "  1,2,3\n-3.5 , .1 , 0\n\n", "1;2;3\r\n-3.5; 1e-1; 0\r\n",
          "x y z\n1 2 3\n-3.5 .1 0", "# a\n// b\n1 2 3 # c\n-3.5 .1 0// d",
          "\xEF\xBB\xBF\"X\",\"Y\",\"Z\"\n1,2,3\n-3.5,.1,0\n", "2\n1 2 3\n-3.5 .1 0"})
      EXPECT_THAT(expect_points(name, text).warnings, IsEmpty()) << name << ": " << text;
  }
}

TEST_F(Spatial_tables, FurtherColumnsAreLeftOutWithAWarning) {
  for (const char* name : {"a.xyz", "a.pts", "a.pwn", "a.csv", "a.txt"}) {
    EXPECT_THAT(expect_points(name, "1 2 3 0 0 1\n-3.5 .1 0 0 nan 0\n").warnings,
                ElementsAre("columns 4 to 6, such as normals, are not read"));
  }
  for (const char* name : {"a.xyz", "a.pts", "a.pwn"}) {
    EXPECT_THAT(expect_points(name, "1 2 3 9\n-3.5 .1 0 9\n").warnings, ElementsAre("column 4 is not read"));
  }
  EXPECT_THAT(expect_points("a.csv", "x,y,z,intensity\n1,2,3,9\n-3.5,.1,0,9\n").warnings,
              ElementsAre("column 4 is not read"));
}

TEST_F(Spatial_tables, FourColumnsOfCsvAndTextAreBalls) {
  for (const char* name : {"a.csv", "a.txt"}) {
    for (const char* text : {"1 2 3 4\n-3.5 0.1 0 0.25\n", "x,y,z,r\n1,2,3,4\n-3.5,0.1,0,0.25\n",
                             "x y z radius\n1 2 3 4\n-3.5 0.1 0 0.25\n", "2\n1 2 3 4\n-3.5 0.1 0 0.25\n"})
      EXPECT_THAT(expect_balls(name, text).warnings, IsEmpty()) << text;
  }
  EXPECT_EQ(folder_.read("a.csv", "1,2,3,0\n").inputs.get(balls_input)->at(0).radius, 0);
}

TEST_F(Spatial_tables, NormalsMayFollowThePoints) {
  EXPECT_THAT(expect_points("a.pwn", "2\n1 2 3\n-3.5 0.1 0\n0 0 1\n0 1 0\n").warnings,
              ElementsAre("the 2 normals after the points are not read"));
}

TEST_F(Spatial_tables, AHeaderAloneIsAnEmptySet) {
  EXPECT_TRUE(folder_.read("a.xyz", "x y z\n").inputs.get(cloud_input)->empty());
  EXPECT_TRUE(folder_.read("a.csv", "x,y,z,r\n").inputs.get(balls_input)->empty());
  EXPECT_TRUE(folder_.read("a.pwn", "0\n").inputs.get(cloud_input)->empty());
}

TEST_F(Spatial_tables, Errors) {
  expect_error("a.xyz", "1 2\n3 4\n", 1, "3 columns x y z or 4 columns x y z radius", "2 columns in '1 2'");
  expect_error("a.csv", "x,y,r\n1,2,3\n", 1, "the columns x y z", "'x,y,r'");
  expect_error("a.csv", "id,x,y,z\n1,2,3,4\n", 1, "the columns x y z", "'id,x,y,z'");
  expect_error("a.csv", "element,kind,id,x\n", 1, "the columns x y z", "'element,kind,id,x'");
  expect_error("a.csv", "x,y\n", 1, "the columns x y z", "'x,y'");
  expect_error("a.xyz", "1 2 3\n4 5\n", 2, "a finite number for z", "nothing");
  expect_error("a.xyz", "1 2 3\n4 5 6 7\n", 2, "3 columns as on the lines before", "4 columns in '4 5 6 7'");
  expect_error("a.xyz", "1 2 3 0 0 1\n4 5 6\n", 2, "6 columns as on the lines before", "3 columns");
  expect_error("a.csv", "1,,3\n", 1, "a finite number for y", "nothing");
  expect_error("a.csv", "1,2,\n", 1, "a finite number for z", "nothing");
  expect_error("a.xyz", "1 2 nan\n", 1, "a finite number for z", "'nan'");
  expect_error("a.xyz", "1 inf 3\n", 1, "a finite number for y", "'inf'");
  expect_error("a.csv", "1 2 3 -1\n", 1, "a radius of at least 0", "'-1'");
  expect_error("a.csv", "1 2 3 inf\n", 1, "a finite number for a radius", "'inf'");
  expect_error("a.xyz", "# nothing\n", 1, "lines x y z or x y z radius", "no numbers");
  expect_error("a.pwn", "5\n1 2 3\n4 5 6\n", 3, "5 points", "2");
  expect_error("a.pwn", "99999999999999\n1 2 3\n4 5 6\n", 3, "99999999999999 points", "2");
  expect_error("a.pwn", "1\n1 2 3 4\n4 5 6 4\n", 3, "1 points", "2");
  using namespace std::string_view_literals;
  expect_error("a.xyz", "1 2 3\n\0"sv, 2, "text", "a zero byte");
}

TEST_F(Spatial_tables, WeightsOfCinAreSquaredRadii) {
  EXPECT_THAT(expect_balls("a.cin", "1 2 3 16\n-3.5\t0.1\t0\t0.0625\n").warnings, IsEmpty());
  expect_error("a.cin", "1 2 3\n", 1, "a finite number for a weight", "nothing");
  expect_error("a.cin", "1 2 3 -4\n", 1, "a squared radius of at least 0", "'-4'");
  expect_error("a.cin", "1 2 3 4 5\n", 1, "4 columns x y z weight", "'1 2 3 4 5'");
  expect_error("a.cin", "# none\n", 1, "lines x y z weight", "no numbers");
}

TEST_F(Spatial_tables, Woff) {
  EXPECT_THAT(expect_balls("a.woff", "WOFF 2 0 0\n1 2 3 4\n-3.5 0.1 0 0.25\n").warnings, IsEmpty());
  expect_balls("a.woff", "# c\nWOFF\n2 0 0\r\n\n1 2 3 4\r\n-3.5 0.1 0 0.25 # last");
  EXPECT_TRUE(folder_.read("a.woff", "WOFF 0 0 0\n").inputs.get(balls_input)->empty());
  expect_error("a.woff", "OFF 2 0 0\n", 1, "'WOFF n 0 0'", "'OFF 2 0 0'");
  expect_error("a.woff", "WOFF 2\n", 1, "the number of faces", "nothing");
  expect_error("a.woff", "WOFF 2 1 0\n", 1, "'WOFF n 0 0'", "'WOFF 2 1 0'");
  expect_error("a.woff", "WOFF x 0 0\n", 1, "an integer of at least 0 for the number of balls", "'x'");
  expect_error("a.woff", "WOFF 9000000000000000000 0 0\n1 2 3 4\n", 2, "9000000000000000000 balls", "1");
  expect_error("a.woff", "WOFF 1 0 0\n1 2 3 4\n5 6 7 8\n", 3, "the end of the file after 1 ball", "'5 6 7 8'");
  expect_error("a.woff", "WOFF 1 0 0\n1 2 3 -4\n", 2, "a radius of at least 0", "'-4'");
  expect_error("a.woff", "WOFF 1 0 0\n1 2 3\n", 2, "a finite number for a radius", "nothing");
}

TEST_F(Spatial_tables, BallsOfMoffAreShrunkBack) {
  EXPECT_THAT(expect_balls("a.moff", "MOFF 2 0 2\n1 2 3 8\n-3.5 0.1 0 0.5\n").warnings, IsEmpty());
  EXPECT_THAT(
      expect_balls("a.moff", "MOFF 2 2 1\n1 2 3 4\n-3.5 0.1 0 .25\n3 0 1 1 60 .5 1 2 3\n4 0 1 0 1 60 .5 1 2 3\n")
          .warnings,
      ElementsAre("the 2 faces of the medial axis are not read"));
  expect_error("a.moff", "MOFF 0 0 0\n", 1, "a positive factor of growth", "'0'");
  expect_error("a.moff", "MOFF 0 0\n", 1, "a factor of growth", "nothing");
  expect_error("a.moff", "MOFF 1 0 1e-300\n1 1 1 1e300\n", 2, "radii that are finite", "one that is not");
  expect_error("a.moff", "MOFF 1 1 1\n1 1 1 1\n3 0 0 1 60 1 1 1 1\n", 3, "a vertex number from 0 to 0", "'1'");
  expect_error("a.moff", "MOFF 1 2 1\n1 1 1 1\n3 0 0 0 60 1 1 1 1\n", 3, "2 faces", "1");
}

TEST_F(Spatial_tables, BallsOfMedialMeshes) {
  EXPECT_THAT(expect_balls("a.ma", "2 0 0\nv 1 2 3 4\nv -3.5 0.1 0 0.25\n# end\n").warnings, IsEmpty());
  EXPECT_THAT(expect_balls("a.ma", "2 1 1\r\nv 1 2 3 4 0\r\nv -3.5 0.1 0 .25 1\r\n\r\ne 0 1\r\nf 0 1 1\r\n").warnings,
              ElementsAre("the 1 edge and 1 face of the medial mesh are not read, only its balls"));
  expect_error("a.ma", "2 0\n", 1, "an integer of at least 0 for the number of faces", "nothing");
  expect_error("a.ma", "2 0 0\nv 1 2 3 4\n", 2, "2 balls, 0 edges and 0 faces", "1, 0 and 0");
  expect_error("a.ma", "1 9000000000000000000 0\nv 1 2 3 4\n", 2, "1 ball, 9000000000000000000 edges", "1, 0 and 0");
  expect_error("a.ma", "1 1 0\nv 1 2 3 4\ne 0 1\n", 3, "a vertex number from 0 to 0", "'1'");
  expect_error("a.ma", "1 0 1\nv 1 2 3 4\nf 0 0\n", 3, "a vertex number from 0 to 0", "nothing");
  expect_error("a.ma", "1 0 0\nw 1 2 3 4\n", 2, "'v x y z radius', 'e i j' or 'f i j k'", "'w 1 2 3 4'");
  expect_error("a.ma", "1 0 0\nv 1 2 3 -1\n", 2, "a radius of at least 0", "'-1'");
}

}  // namespace
}  // namespace mesecina
