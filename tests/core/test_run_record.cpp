// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/run_record.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

namespace mesecina {
namespace {

Run_record record(int number, double seconds) {
  Run_record run;
  run.number = number;
  run.what = "Move, \"3\" points";
  run.seconds = seconds;
  run.counts = {{"points", 100}};
  run.layers = {{"axis", "Axis", 12, 13, Topology{1, {1, 0, 0}}, ""}, {"crust", "Crust", 0, 0, {}, "too few"}};
  run.stages = {{"delaunay", 0.25, false}, {"axis", 0.5, false}, {"delaunay", 0.125, true}};
  return run;
}

TEST(Run_record_test, stages_are_added_up) {
  const auto rows = rows_of(record(1, 1));
  const auto row = std::ranges::find(rows, "delaunay", &Run_row::name);
  ASSERT_NE(row, rows.end());
  EXPECT_EQ(row->number, 0.375);
}

TEST(Run_record_test, runs_stand_side_by_side) {
  std::vector<Run_record> runs{record(1, 1), record(2, 2)};
  runs[1].counts["disks"] = 7;
  runs[1].counts.erase("points");
  const auto rows = compared_rows(runs);
  EXPECT_EQ(rows[0].name, "points");
  EXPECT_TRUE(rows[0].runs[0]);
  EXPECT_FALSE(rows[0].runs[1]);
  EXPECT_EQ(rows[1].name, "disks");
  EXPECT_EQ(rows[1].section, "Input");
  EXPECT_EQ(rows[1].runs[1]->number, 7);
}

TEST(Run_record_test, tables_have_a_column_per_run) {
  const std::string csv = to_csv(std::vector<Run_record>{record(1, 0.1), record(2, 0.2)});
  EXPECT_TRUE(csv.starts_with("section,name,run 1,run 2\nRun,what,\"Move, \"\"3\"\" points\","));
  EXPECT_NE(csv.find("\nSeconds,all,0.1,0.2\n"), std::string::npos);
  EXPECT_NE(csv.find("\nLayers,Crust,too few,too few\n"), std::string::npos);
  const auto json = nlohmann::json::parse(to_json(std::vector<Run_record>{record(1, 0.1)}));
  EXPECT_EQ(json[0]["layers"]["axis"]["euler"], 1);
  EXPECT_EQ(json[0]["seconds"]["delaunay"], 0.375);
}

}  // namespace
}  // namespace mesecina
