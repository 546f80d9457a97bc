// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "layers/picture_formats.h"

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  const mesecina::Picture_application application;
  return RUN_ALL_TESTS();
}
