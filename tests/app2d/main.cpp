// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <QApplication>
#include <QLocale>
#include <QSettings>
#include <QTemporaryDir>

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  // As the program does; preferences of whoever runs the tests stay as they are.
  QLocale::setDefault(QLocale::c());
  const QTemporaryDir preferences;
  QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, preferences.path());
  QApplication application(argc, argv);
  return RUN_ALL_TESTS();
}
