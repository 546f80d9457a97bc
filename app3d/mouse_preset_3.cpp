// SPDX-License-Identifier: GPL-3.0-or-later
#include "app3d/mouse_preset_3.h"

#include <QCoreApplication>
#include <QStringList>
#include <array>
#include <utility>

namespace mesecina {

namespace {

constexpr std::array names{std::pair{Mouse_preset::standard, "standard"}, std::pair{Mouse_preset::blender, "blender"},
                           std::pair{Mouse_preset::cad, "cad"}};

QString tr(const char* text) { return QCoreApplication::translate("mesecina::Mouse_preset", text); }

QString name_of(const Mouse_binding& binding, Mouse_preset preset) {
  QString name = binding.button == Qt::MiddleButton ? tr("middle")
                 : selects_by_drag(preset)          ? tr("left (turn, add)")
                                                    : tr("left");
  if (binding.modifiers & Qt::ShiftModifier) name = tr("Shift + %1").arg(name);
  if (binding.modifiers & Qt::ControlModifier) name = tr("Ctrl + %1").arg(name);
  name[0] = name[0].toUpper();
  return name;
}

}  // namespace

std::vector<Mouse_binding> mouse_bindings(Mouse_preset preset) {
  switch (preset) {
    case Mouse_preset::blender:
      return {{Qt::NoModifier, Qt::MiddleButton, Camera_drag::turn},
              {Qt::ShiftModifier, Qt::MiddleButton, Camera_drag::move},
              {Qt::ControlModifier, Qt::MiddleButton, Camera_drag::zoom},
              {Qt::NoModifier, Qt::LeftButton, Camera_drag::turn}};
    case Mouse_preset::cad:
      return {{Qt::NoModifier, Qt::MiddleButton, Camera_drag::turn},
              {Qt::ControlModifier, Qt::MiddleButton, Camera_drag::move},
              {Qt::ShiftModifier, Qt::MiddleButton, Camera_drag::zoom},
              {Qt::NoModifier, Qt::LeftButton, Camera_drag::turn}};
    default:
      return {{Qt::NoModifier, Qt::LeftButton, Camera_drag::turn},
              {Qt::NoModifier, Qt::MiddleButton, Camera_drag::move},
              {Qt::ShiftModifier, Qt::LeftButton, Camera_drag::move},
              {Qt::ControlModifier, Qt::MiddleButton, Camera_drag::zoom}};
  }
}

bool selects_by_drag(Mouse_preset preset) { return preset != Mouse_preset::standard; }

std::vector<Gesture> camera_gestures(Mouse_preset preset) {
  std::vector<Gesture> gestures;
  for (const auto& [drag, text] :
       {std::pair{Camera_drag::turn, tr("Turn the scene")}, std::pair{Camera_drag::move, tr("Move the view")},
        std::pair{Camera_drag::zoom, tr("Zoom")}}) {
    QStringList ways;
    for (const Mouse_binding& binding : mouse_bindings(preset))
      if (binding.drag == drag) ways << name_of(binding, preset);
    gestures.push_back({ways.join(QStringLiteral(", ")), text});
  }
  if (selects_by_drag(preset)) gestures.push_back({tr("Drag on nothing (select)"), tr("Select in a rectangle")});
  return gestures;
}

QString preset_name(Mouse_preset preset) {
  for (const auto& [known, name] : names)
    if (known == preset) return QString::fromLatin1(name);
  return {};
}

Mouse_preset preset_named(const QString& name) {
  for (const auto& [preset, known] : names)
    if (name == QLatin1String(known)) return preset;
  return Mouse_preset::standard;
}

}  // namespace mesecina
