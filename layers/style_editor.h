// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "core/registry.h"
#include "core/style.h"

class QCheckBox;
class QColorDialog;
class QComboBox;
class QGridLayout;
class QLabel;
class QPushButton;
class QSlider;
class QToolButton;

namespace mesecina {

class Automatic_dot;
class Histogram_widget;
class Number_field;

/// The look of one or several layers. Where they differ it says "mixed"; a change is one to all of them.
class Style_editor : public QWidget {
  Q_OBJECT
 public:
  /// One of the layers shown, and what its cut's setting allows.
  struct Subject {
    Scene_layer layer;
    QString cut_setting;  ///< id; empty for layers without a cut
    QString cut_label;
    double cut_lowest = 0;
    double cut_highest = 0;
    double cut_default = 0;
  };
  using Change = std::function<void(Style&)>;

  explicit Style_editor(QWidget* parent = nullptr);

  /// The first one is whose histogram is shown; none for nothing selected.
  void set_subjects(std::vector<Subject> subjects);
  /// Opens what chooses the colour: of the layer or, where values choose it, the colour map.
  void choose_color();
  void focus_first();

 Q_SIGNALS:
  /// `what` names the property in the user's words; changes with the same `merge` are one for undo.
  void edited(const mesecina::Style_editor::Change& change, const QString& what, const QString& merge);
  /// nullopt: back to the default.
  void cut_edited(const QString& setting, const std::optional<double>& value, const QString& merge);

 protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  struct Slider_row {
    QSlider* slider = nullptr;
    Number_field* field = nullptr;
    double unit = 1;  ///< of the field, per step of the slider
  };
  /// Two ends of a range, each with a dot that shows whether it was chosen and makes it automatic again.
  struct Limits_row {
    QLabel* label = nullptr;
    QWidget* box = nullptr;
    Number_field* minimum = nullptr;
    Number_field* maximum = nullptr;
    Automatic_dot* minimum_dot = nullptr;
    Automatic_dot* maximum_dot = nullptr;
  };
  struct Switch {
    QCheckBox* box = nullptr;
    bool Style::*member = nullptr;
  };
  using Member = std::optional<double> Style::*;

  void build_color_row(QGridLayout* grid);
  void build_space_row(QGridLayout* grid);
  /// `property` names the step of undo among those of one gesture.
  QCheckBox* build_switch(QWidget* parent, const QString& label, const QString& tool_tip, bool Style::*member,
                          const QString& step, const QString& property);
  Slider_row build_slider_row(QGridLayout* grid, const QString& label, const QString& tool_tip, double lowest,
                              double highest, double unit, const QString& suffix, double scale, double Style::*member);
  void build_value_rows(QGridLayout* grid);
  Limits_row build_limits_row(QGridLayout* grid, const QString& label, const QString& tool_tip, Member minimum,
                              Member maximum);
  void build_cut_row(QGridLayout* grid);
  void build_histogram(QGridLayout* grid);
  QLabel* add_row(QGridLayout* grid, const QString& label, QWidget* field, const QString& tool_tip);

  void open_color_dialog();
  void refresh();
  void refresh_color();
  void refresh_switches();
  void refresh_slider(const Slider_row& row, double Style::*member, double scale);
  void refresh_value_choice();
  void refresh_limits(const Limits_row& row, Member minimum, Member maximum,
                      const std::optional<double>& automatic_minimum, const std::optional<double>& automatic_maximum);
  void refresh_cut(bool has_cut);
  void refresh_histogram(const std::string& value, bool has_cut);
  void edit(const Change& change, const QString& what, const QString& property);
  void edit_limit(Member member, const std::optional<double>& value);
  void edit_cut(const std::optional<double>& value);
  QString merge_key(const QString& property) const;
  void end_gesture() { ++gesture_; }
  /// The common value of a member, nullopt where the subjects differ.
  template <class T>
  std::optional<T> common(T Style::*member) const;
  std::vector<std::string> offered_values() const;

  std::vector<Subject> subjects_;
  int gesture_ = 0;
  bool is_outdated_ = false;  ///< there was no need to refresh while hidden
  QPushButton* color_button_ = nullptr;
  std::vector<Switch> switches_;
  QWidget* space_row_ = nullptr;  ///< what only layers in space have
  QLabel* space_label_ = nullptr;
  Slider_row opacity_, point_size_, line_width_;
  QComboBox* value_combo_ = nullptr;
  QLabel* color_map_label_ = nullptr;
  QWidget* color_map_row_ = nullptr;
  QComboBox* color_map_combo_ = nullptr;
  QToolButton* reversed_button_ = nullptr;
  Limits_row range_, threshold_;
  QLabel* cut_label_ = nullptr;
  QWidget* cut_row_ = nullptr;
  Number_field* cut_field_ = nullptr;
  Automatic_dot* cut_dot_ = nullptr;
  Histogram_widget* histogram_ = nullptr;
  QColorDialog* color_dialog_ = nullptr;
};

}  // namespace mesecina
