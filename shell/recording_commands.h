// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>
#include <vector>

#include "core/batch/command_line.h"
#include "core/film_wish.h"
#include "shell/commands.h"

namespace mesecina {

/// What the words after "record FILE" ask for.
struct Record_order {
  Film_wish wish;
  std::vector<Evolution_order> evolutions;  ///< steps to be made first
};

/// Reads the words, which are those of the command line: --sweep ID=FROM:TO:STEPS, --evolve ID=STEPS, --turntable
/// FRAMES,
/// --fps N, --size WxH, --transparent; and --evolution, the steps that there are. What they do not say is as in
/// `usual`, what moves too. Throws Command_error for other words, and for frames of two kinds.
Record_order record_order(const QStringList& words, const Film_wish& usual, const Registry& registry);

/// The command "record"; `run` is given what it asks for.
Command record_command(const Registry& registry, std::function<Film_wish()> usual,
                       std::function<void(const Record_order&)> run);

}  // namespace mesecina
