// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QScrollArea>
#include <QStringList>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "core/registry.h"

class QLabel;
class QToolButton;
class QVBoxLayout;

namespace mesecina {

/// Every setting of the registry with a control that suits its type, grouped by module. It owns no truth: it shows what
/// it was given and says what the user wants changed.
class Settings_panel : public QScrollArea {
  Q_OBJECT
 public:
  explicit Settings_panel(std::shared_ptr<const Registry> registry, QWidget* parent = nullptr);

  void set_settings(const Settings& settings);
  /// How far the slider of a setting goes, though never beyond the bound of the setting. Larger numbers can be typed.
  void set_slider_maximum(const std::string& setting, double maximum);
  /// Lists only settings with all these words in their label, id, help, unit, module or evolution; with `changed_only`
  /// only those that differ from their defaults.
  void set_filter(const QString& words, bool changed_only);
  /// The ids of those that are listed, from top to bottom.
  std::vector<std::string> listed() const;
  /// Scrolls to the setting and gives its control the focus. Does nothing for an unknown one.
  void focus_setting(const std::string& setting);

 Q_SIGNALS:
  /// `merge` is the same for all steps of one drag.
  void edited(const mesecina::Settings& settings, const QString& what, const QString& merge);
  /// The number shall move; as far as its slider goes, unless somebody knows better.
  void animate_requested(const QString& setting, double from, double to);

 private:
  QString tip_of(const Setting_spec& spec) const;
  struct Row {
    std::function<void(const Setting_value&)> show;
    std::function<void(double)> set_slider_maximum;
    std::function<void()> animate;  ///< of numbers
    QToolButton* reset = nullptr;
    QWidget* line = nullptr;  ///< all of it
    QString words;            ///< that it is found by
    QWidget* heading = nullptr;
    QWidget* editor = nullptr;  ///< the control, or what holds it
  };
  void add_row(const Setting_spec& spec, QVBoxLayout* column, QWidget* heading);
  bool is_listed(const std::string& id, const Row& row) const;
  void apply_filter();
  QWidget* make_animate_button(const Setting_spec& spec, const Row& row);
  QWidget* make_switch(const Setting_spec& spec, Row& row);
  QWidget* make_text(const Setting_spec& spec, Row& row);
  QWidget* make_number(const Setting_spec& spec, Row& row);
  void change(const Setting_spec& spec, const Setting_value& value, const QString& merge);

  std::shared_ptr<const Registry> registry_;
  Settings settings_;
  std::map<std::string, Row> rows_;
  QStringList filter_;
  bool changed_only_ = false;
  QLabel* nothing_ = nullptr;  ///< shown when no setting is listed
  int gesture_ = 0;            ///< numbers the drags: one is one step of undo
};

}  // namespace mesecina
