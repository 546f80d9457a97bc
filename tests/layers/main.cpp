// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "layers/picture_formats.h"

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  // The names of the tests are asked for while the tests are set up, where there need be no platform for an
  // application.
  if (testing::GTEST_FLAG(list_tests)) return RUN_ALL_TESTS();
  const mesecina::Picture_application application;
  return RUN_ALL_TESTS();
}
