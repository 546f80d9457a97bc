// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <QApplication>
#include <QFile>
#include <QLocale>
#include <QSettings>
#include <QTemporaryDir>

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  // The names of the tests are asked for while the tests are set up, where there need be no platform for an
  // application.
  if (testing::GTEST_FLAG(list_tests)) return RUN_ALL_TESTS();
  // Nobody is there to answer whether to save; and the tests are about the window, not about drivers.
  qputenv("MESECINA_NO_PROMPT", "1");
  qputenv("MESECINA_CANVAS", "painter");
  // As the program does; preferences of whoever runs the tests stay as they are.
  QLocale::setDefault(QLocale::c());
  const QTemporaryDir preferences;
  qputenv("XDG_DATA_HOME", QFile::encodeName(preferences.path()));
  QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, preferences.path());
  QApplication application(argc, argv);
  return RUN_ALL_TESTS();
}
