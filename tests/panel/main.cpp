// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <QApplication>
#include <QLocale>

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  // The names of the tests are asked for while the tests are set up, where there need be no platform for an
  // application.
  if (testing::GTEST_FLAG(list_tests)) return RUN_ALL_TESTS();
  // A decimal comma wherever Qt's default locale is used: no number of the panel may follow it.
  QLocale::setDefault(QLocale(QLocale::German, QLocale::Germany));
  QApplication application(argc, argv);
  return RUN_ALL_TESTS();
}
