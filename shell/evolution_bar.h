// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "shell/actions.h"
#include "shell/computation.h"
#include "shell/evolution_control.h"

class QAction;
class QBoxLayout;
class QComboBox;
class QSpinBox;
class QToolButton;

namespace mesecina {

class Step_slider;

/// Evolutions at the edge of a canvas: which one, its steps on a slider, playing, repeating, and the memory of
/// pictures. In one row where there is room, else in two. It owns no truth: it shows what the control and the document
/// say.
class Evolution_bar : public QWidget {
  Q_OBJECT
 public:
  /// The actions "evolution-..." must be there.
  Evolution_bar(Evolution_control& control, Computation& computation, const Actions& actions,
                QWidget* parent = nullptr);

 Q_SIGNALS:
  void budget_edited(int megabytes);

 protected:
  void changeEvent(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  QWidget* make_transport(const Actions& actions);
  QWidget* make_options(const Actions& actions);
  QToolButton* make_button(QAction* action, QWidget* parent) const;
  QSpinBox* make_field(int minimum, int maximum, const QString& name, const QString& tip, QWidget* parent) const;
  void show_fitness();
  void show_control();
  void show_track();
  void show_memory();

  Evolution_control& control_;
  Computation& computation_;
  QBoxLayout* rows_ = nullptr;
  QWidget* transport_ = nullptr;
  QWidget* options_ = nullptr;
  QComboBox* evolutions_ = nullptr;
  Step_slider* slider_ = nullptr;
  QSpinBox* position_ = nullptr;
  QSpinBox* ahead_ = nullptr;
  QComboBox* repeat_ = nullptr;
  QSpinBox* range_begin_ = nullptr;
  QSpinBox* range_end_ = nullptr;
  QSpinBox* speed_ = nullptr;
  QSpinBox* memory_ = nullptr;
};

}  // namespace mesecina
