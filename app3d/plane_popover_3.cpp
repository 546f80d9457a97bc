// SPDX-License-Identifier: GPL-3.0-or-later
#include "app3d/plane_popover_3.h"

#include <QCoreApplication>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QToolButton>
#include <array>
#include <cmath>
#include <limits>

#include "layers/number_field.h"

namespace mesecina {

namespace {

class Plane_popover_3 : public Popover {
  Q_DECLARE_TR_FUNCTIONS(mesecina::Plane_popover_3)
 public:
  Plane_popover_3(Plane_handle_3& handle, Viewer_3& viewer, const Actions& actions)
      : Popover(tr("Cutting plane"), &viewer), plane_(handle), viewer_(viewer) {
    const auto make_field = [&](const QString& name, const QString& tip) {
      auto* field = new Number_field(this);
      field->setAccessibleName(name);
      field->setToolTip(tip);
      return field;
    };
    place_ = make_field(tr("Distance"), tr("From the middle of what is shown, along the normal, in its units"));
    form()->addRow(tr("Distance"), place_);
    auto* row = new QHBoxLayout;
    const std::array names{tr("Normal x"), tr("Normal y"), tr("Normal z")};
    for (std::size_t i = 0; i < normal_.size(); ++i) {
      normal_[i] = make_field(names[i], tr("Of the direction that is cut away; any length"));
      row->addWidget(normal_[i]);
      connect(normal_[i], &Number_field::edited, this, [this] { take_normal(); });
    }
    form()->addRow(tr("Normal"), row);
    thickness_ =
        make_field(tr("Thickness"), tr("Of the slab that is left, in units of what is shown; empty: all on one side"));
    thickness_->set_optional(true);
    thickness_->set_bounds(0, std::numeric_limits<double>::infinity());
    form()->addRow(tr("Slab"), thickness_);
    auto* buttons = new QHBoxLayout;
    for (const char* id : {"plane-x", "plane-y", "plane-z", "plane-view", "plane-flip"}) {
      auto* button = new QToolButton(this);
      button->setDefaultAction(actions[QLatin1String(id)]);
      button->setAccessibleName(button->text());
      buttons->addWidget(button);
    }
    buttons->addStretch();
    column()->addLayout(buttons);
    connect(place_, &Number_field::edited, this, [this](const std::optional<double>& value) {
      if (const auto plane = viewer_.view().cutting_plane; plane && value)
        viewer_.set_cutting_plane(shifted(*plane, *value - distance_of_plane()));
    });
    connect(thickness_, &Number_field::edited, this, [this](const std::optional<double>& value) {
      if (auto plane = viewer_.view().cutting_plane) {
        plane->thickness = value;
        viewer_.set_cutting_plane(plane);
      }
    });
    // Each finished change is one to go back from.
    viewer_.remember_view();
    for (const Number_field* field : {place_, thickness_, normal_[0], normal_[1], normal_[2]})
      connect(field, &Number_field::finished, this, [this] { viewer_.remember_view(); });
    connect(&viewer_, &Viewer_3::view_changed, this, [this] { follow(); });
    follow();
  }

 private:
  double distance_of_plane() const {
    const Plane_frame_3 frame = *plane_.frame();
    return dot(frame.center - plane_.middle(), frame.normal);
  }

  void follow() {
    const bool is_closed = shown_ && isHidden();
    if (is_closed) return;
    const auto plane = viewer_.view().cutting_plane;
    if (!plane) {
      dismiss();
      return;
    }
    if (plane == shown_) return;
    shown_ = plane;
    const Point_3 normal = plane_.frame()->normal;
    constexpr double part = 1e-6;
    const double size = std::pow(10, std::floor(std::log10(plane_.box().diagonal())));
    place_->show_value(rounded(distance_of_plane(), part * size));
    const std::array numbers{normal.x, normal.y, normal.z};
    for (std::size_t i = 0; i < normal_.size(); ++i) normal_[i]->show_value(rounded(numbers[i], part));
    thickness_->show_value(plane->thickness, tr("none"), size / 10);
  }

  /// To a multiple, which is nicer to read.
  static double rounded(double number, double unit) {
    const double per_unit = std::round(1 / unit);
    return per_unit >= 1 ? std::round(number * per_unit) / per_unit : std::round(number / unit) * unit;
  }

  void take_normal() {
    const std::array numbers{normal_[0]->value(), normal_[1]->value(), normal_[2]->value()};
    const Point_3 normal{numbers[0].value_or(0), numbers[1].value_or(0), numbers[2].value_or(0)};
    if (!(dot(normal, normal) > 0)) return;
    const auto plane = viewer_.view().cutting_plane;
    if (plane) viewer_.set_cutting_plane(aligned(*plane, plane_.frame()->center, normal));
  }

  Plane_handle_3& plane_;
  Viewer_3& viewer_;
  std::optional<Cutting_plane_3> shown_;
  Number_field* place_ = nullptr;
  std::array<Number_field*, 3> normal_{};
  Number_field* thickness_ = nullptr;
};

}  // namespace

Popover* make_plane_popover(Plane_handle_3& plane, Viewer_3& viewer, const Actions& actions) {
  auto* popover = new Plane_popover_3(plane, viewer, actions);
  popover->open();
  return popover;
}

}  // namespace mesecina
