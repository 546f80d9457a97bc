// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/panel/panel_fixture.h"

#include <QTest>

namespace mesecina {

std::shared_ptr<const Registry> make_registry() {
  auto registry = std::make_shared<Registry>();
  registry->begin_module({"test", "Test", "Layers for tests"});
  Setting_spec limit;
  limit.id = "limit";
  limit.label = "Limit";
  limit.default_value = 2.0;
  limit.minimum = 0;
  limit.maximum = 10;
  registry->add_setting(limit);
  for (const std::string id : {"a", "b", "c", "d", "e"}) {
    Layer_spec layer;
    layer.id = id;
    layer.label = "Layer " + id;
    layer.stage = id < "d" ? "First" : "Second";
    layer.help = id == "b" ? "The needle in the haystack" : "Help of " + id;
    layer.style.visible = id == "a" || id == "d";
    layer.build = [](Context&) { return Primitive_set(); };
    if (id == "e") {
      layer.cut_value = "lambda";
      layer.cut_setting = "limit";
    }
    registry->add_layer(layer);
  }
  return registry;
}

std::shared_ptr<const Primitive_set> make_points(double scale) {
  auto set = std::make_shared<Primitive_set>();
  Values lambda{"lambda", "", {}};
  Values weight{"weight", "", {}};
  for (int i = 0; i <= 100; ++i) {
    set->vertices.push_back({static_cast<double>(i), 0, 0});
    set->points.push_back(i);
    lambda.data.push_back(i / scale);
    weight.data.push_back(3);
  }
  set->values = {lambda, weight};
  return set;
}

Panel_test::Panel_test() {
  panel_.set_layers(default_layers(*registry_));
  QObject::connect(&panel_, &Layer_panel::layers_edited, &panel_,
                   [this](const Layer_list& layers, const QString& what, const QString& merge) {
                     edits_.push_back({layers, what, merge});
                     panel_.set_layers(layers);
                   });
  QObject::connect(&panel_, &Layer_panel::setting_edited, &panel_,
                   [this](const QString& setting, double value, const QString& merge) {
                     setting_edits_.push_back({setting, value, merge});
                     panel_.set_settings(Settings().with(setting.toStdString(), value));
                   });
  panel_.resize(300, 900);
  panel_.show();
  EXPECT_TRUE(QTest::qWaitForWindowExposed(&panel_));
}

Layer_tree& Panel_test::tree() const { return *panel_.findChild<Layer_tree*>(); }

QModelIndex Panel_test::row(const QString& layer) const {
  const QModelIndexList found =
      tree().model()->match(stage(0), Qt::UserRole, layer, 1, Qt::MatchExactly | Qt::MatchRecursive | Qt::MatchWrap);
  return found.isEmpty() ? QModelIndex() : found.front();
}

QModelIndex Panel_test::stage(int number) const { return tree().model()->index(number, 0); }

QPoint Panel_test::part(const QModelIndex& index, Layer_delegate::Part part) const {
  return tree().delegate().part_rectangle(index, tree().visualRect(index), tree().font(), part).center();
}

void Panel_test::click(const QModelIndex& index, Layer_delegate::Part clicked, Qt::KeyboardModifiers modifiers) {
  QTest::mouseClick(tree().viewport(), Qt::LeftButton, modifiers, part(index, clicked));
}

const Style& Panel_test::style(const std::string& layer) const { return find_entry(panel_.layers(), layer)->style; }

std::string Panel_test::visible() const {
  std::string result;
  for (const Layer_entry& entry : panel_.layers()) {
    if (entry.style.visible) result += entry.id;
  }
  return result;
}

std::string Panel_test::order() const {
  std::string result;
  for (const Layer_entry& entry : panel_.layers()) result += entry.id;
  return result;
}

std::string Panel_test::shown() const {
  std::string result;
  for (int s = 0; s < tree().model()->rowCount(); ++s) {
    if (tree().isRowHidden(s, {})) continue;
    for (int i = 0; i < tree().model()->rowCount(stage(s)); ++i) {
      if (!tree().isRowHidden(i, stage(s))) {
        result += tree().model()->index(i, 0, stage(s)).data(Qt::UserRole).toString().toStdString();
      }
    }
  }
  return result;
}

}  // namespace mesecina
