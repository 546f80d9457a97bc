// SPDX-License-Identifier: GPL-3.0-or-later
#include <QFile>
#include <QTreeWidget>
#include <QtTest>
#include <nlohmann/json.hpp>

#include "window_fixture.h"

namespace mesecina {
namespace {

class Window_reports : public Window_fixture {
 protected:
  QByteArray content(const QString& path) {
    QFile file(path);
    EXPECT_TRUE(file.open(QIODevice::ReadOnly)) << path.toStdString();
    return file.readAll();
  }
  const std::vector<Run_record>& runs() { return window().statistics().runs(); }
  bool has_come_to_rest() { return !window().evolution().evolver().is_busy() && !window().computation().is_busy(); }
  /// Three steps of Laplacian smoothing; whether they came to rest.
  bool make_three_steps() {
    Evolution_control& control = window().evolution();
    if (!wait_until_current("one-step-crust")) return false;
    control.choose("laplacian-smoothing");
    control.set_steps_ahead(3);
    control.make_steps();
    return wait_until([&] { return document().position() == 3 && has_come_to_rest(); });
  }
};

TEST_F(Window_reports, EveryStepIsARunWithItsCountsAndTopology) {
  trigger("show-statistics");
  ASSERT_TRUE(wait_until_current("one-step-crust"));
  document().edit_inputs(Inputs().with(points_input, std::vector<Point_2>{{0, 0}, {4, 0}, {4, 3}, {0, 3}}), "Square");
  ASSERT_TRUE(wait_until([&] { return !runs().empty() && runs().back().what == "Square"; }));
  ASSERT_TRUE(wait_until([&] {
    const auto& layers = runs().back().layers;
    const auto crust = std::ranges::find(layers, "one-step-crust", &Layer_record::id);
    return crust != layers.end() && crust->topology.has_value();
  }));
  const Run_record run = runs().back();
  EXPECT_EQ(run.counts.at("points"), 4u);
  EXPECT_GT(run.memory, 1000000u);
  EXPECT_FALSE(run.stages.empty());
  const auto crust = std::ranges::find(run.layers, "one-step-crust", &Layer_record::id);
  EXPECT_EQ(crust->elements, 4u);
  EXPECT_EQ(crust->topology->euler, 0);
  EXPECT_EQ(crust->topology->betti, (std::array<std::int64_t, 3>{1, 1, 0}));

  const QString json = folder_.filePath("runs.json");
  window().statistics().write(json);
  const auto list = nlohmann::json::parse(content(json).toStdString());
  EXPECT_EQ(list.size(), runs().size());
  EXPECT_EQ(list.back()["layers"]["one-step-crust"]["betti"], (nlohmann::json{1, 1, 0}));
  const QString csv = folder_.filePath("runs.csv");
  window().statistics().write(csv);
  EXPECT_TRUE(content(csv).contains("Input,points,"));
}

TEST_F(Window_reports, ARunInAnEvolutionNamesItsStep) {
  Evolution_control& control = window().evolution();
  ASSERT_TRUE(make_three_steps());
  EXPECT_EQ(runs().back().what, "Laplacian smoothing: step 3 of 3");
  // A layer that was not on while they were made.
  Layer_list layers = document().layers();
  for (Layer_entry& entry : layers) entry.style.visible = entry.id == "delaunay" || entry.style.visible;
  document().edit_layers(layers, "Show Delaunay");
  for (const std::size_t position : {3, 2, 1}) {
    control.go_to(position);
    const std::string name = "Laplacian smoothing: step " + std::to_string(position) + " of 3";
    ASSERT_TRUE(wait_until([&] { return has_come_to_rest() && runs().back().what == name; })) << runs().back().what;
  }
  control.go_to(0);
  ASSERT_TRUE(wait_until([&] { return has_come_to_rest() && runs().back().what == "Before the first step"; }));
}

TEST_F(Window_reports, GoingToStepsThatWereSeenAddsNoRuns) {
  Evolution_control& control = window().evolution();
  ASSERT_TRUE(make_three_steps());
  for (const std::size_t position : {3, 2, 1, 0}) {
    control.go_to(position);
    ASSERT_TRUE(wait_until([&] { return has_come_to_rest(); }));
  }
  const std::size_t before = runs().size();
  for (const std::size_t position : {1, 2, 3, 0, 2}) {
    control.go_to(position);
    bool is_answered = false;
    window().computation().describe("one-step-crust", 0, [&](const Element_description&) { is_answered = true; });
    ASSERT_TRUE(wait_until([&] { return is_answered; }));
  }
  EXPECT_EQ(runs().size(), before);
}

TEST_F(Window_reports, TheLogSaysWhatFailedAndLeadsThere) {
  document().edit_inputs(Inputs().with(points_input, std::vector<Point_2>{{0, 0}}), "One point");
  Layer_list layers = document().layers();
  for (Layer_entry& entry : layers) entry.style.visible = entry.id == "medial-axis";
  document().edit_layers(layers, "axis");
  const auto of_axis = [&] {
    return std::ranges::find(window().log().entries(), QStringLiteral("medial-axis"), &Log_panel::Entry::layer);
  };
  ASSERT_TRUE(wait_until([&] { return of_axis() != window().log().entries().end(); }));
  EXPECT_EQ(of_axis()->kind, Message_bar::Kind::error);
  EXPECT_TRUE(window().log().text().contains(of_axis()->text));
  window().layer_panel().select({"points"});
  auto* list = window().log().findChild<QTreeWidget*>();
  const auto number = static_cast<int>(of_axis() - window().log().entries().begin());
  Q_EMIT list->itemActivated(list->topLevelItem(number), 0);
  EXPECT_EQ(window().layer_panel().selected(), QStringList{"medial-axis"});

  window().messages().add(Message_bar::Kind::warning, "something");
  EXPECT_EQ(window().log().entries().back().text, "something");
}

TEST_F(Window_reports, AnEntryWithAPlaceLeadsThereAndSelectsWhatIsThere) {
  std::vector<Point_2> curve;
  for (int i = 0; i < 40; ++i) curve.push_back({10 * std::cos(i * 0.157), 10 * std::sin(i * 0.157)});
  curve.push_back(curve[7]);
  document().edit_inputs(Inputs().with(points_input, curve), "Twice the same");
  const auto& entries = window().log().entries();
  const auto merged = [&] {
    return std::ranges::find_if(entries, [](const Log_panel::Entry& entry) { return entry.text.contains("equal"); });
  };
  ASSERT_TRUE(wait_until([&] { return merged() != entries.end(); }));
  ASSERT_EQ(merged()->places.size(), 1u);
  EXPECT_EQ(merged()->places[0].input, "points");
  const std::size_t element = merged()->places[0].element;
  EXPECT_TRUE(element == 7 || element == 40);
  trigger("fit");
  const View_2 before = canvas().view();
  auto* list = window().log().findChild<QTreeWidget*>();
  Q_EMIT list->itemActivated(list->topLevelItem(static_cast<int>(merged() - entries.begin())), 0);
  EXPECT_GT(canvas().view().scale, 2 * before.scale);
  EXPECT_NEAR(canvas().view().center.x, curve[7].x, 1e-9);
  EXPECT_NEAR(canvas().view().center.y, curve[7].y, 1e-9);
  EXPECT_EQ(window().editor().selection().points, std::vector<std::size_t>{element});

  // What is gone by then is not selected.
  const Log_panel::Entry entry = *merged();
  document().edit_inputs(Inputs().with(points_input, std::vector<Point_2>{{0, 0}, {4, 0}, {4, 3}}), "Fewer");
  Q_EMIT window().log().places_chosen(entry.places);
  EXPECT_TRUE(window().editor().selection().points.empty());
}

TEST(Log_places, PathsAreFoundInMessages) {
  const QTemporaryDir folder;
  const QString path = folder.filePath("a.xy");
  EXPECT_EQ(path_in("Wrote " + path), QString());
  QFile file(path);
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  EXPECT_EQ(path_in("Wrote " + path), path);
  EXPECT_EQ(path_in(path + ":12: expected a number, found 'x'"), path);
  EXPECT_EQ(path_in("nothing at all"), QString());
}

}  // namespace
}  // namespace mesecina
