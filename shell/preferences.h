// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QSettings>
#include <QString>
#include <QVariant>

namespace mesecina {

/// What a program remembers between runs that is no data: geometry of the window, recent files, theme, folders.
class Preferences {
 public:
  /// `program` is the file's name ("mesecina2d").
  explicit Preferences(const QString& program)
      : settings_(QSettings::IniFormat, QSettings::UserScope, QStringLiteral("mesecina"), program) {}

  QVariant value(const QString& key, const QVariant& otherwise = {}) const { return settings_.value(key, otherwise); }
  void set_value(const QString& key, const QVariant& value) { settings_.setValue(key, value); }

 private:
  QSettings settings_;
};

}  // namespace mesecina
