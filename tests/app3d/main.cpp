// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <QApplication>
#include <QFile>
#include <QLocale>
#include <QSettings>
#include <QSurfaceFormat>
#include <QTemporaryDir>

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  // The names of the tests are asked for while the tests are set up, where there need be no display.
  if (testing::GTEST_FLAG(list_tests)) return RUN_ALL_TESTS();
  qputenv("MESECINA_NO_PROMPT", "1");
  // As the program does; preferences of whoever runs the tests stay as they are.
  QLocale::setDefault(QLocale::c());
  QSurfaceFormat format;
  format.setVersion(3, 3);
  format.setProfile(QSurfaceFormat::CompatibilityProfile);
  format.setOption(QSurfaceFormat::DeprecatedFunctions);
  QSurfaceFormat::setDefaultFormat(format);
  QCoreApplication::setAttribute(Qt::AA_ShareOpenGLContexts);
  const QTemporaryDir preferences;
  qputenv("XDG_DATA_HOME", QFile::encodeName(preferences.path()));
  QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, preferences.path());
  QApplication application(argc, argv);
  return RUN_ALL_TESTS();
}
