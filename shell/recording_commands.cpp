// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/recording_commands.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>
#include <utility>

#include "core/formats/number.h"

namespace mesecina {

namespace {

using Source = Film_wish::Source;

QString tr(const char* text) { return QCoreApplication::translate("commands", text); }

/// The number in a word, from `least` on; whole if wanted.
double number_in(const QString& option, const QString& word, double least, bool is_whole) {
  const auto number = parse_number(word.toStdString());
  constexpr double most = most_sweep_steps;
  const bool is_good = number && *number >= least && *number <= most && (!is_whole || *number == std::floor(*number));
  if (!is_good)
    throw Command_error(tr("record: expected %1 for %2, found '%3'")
                            .arg(is_whole ? tr("a whole number from %1 to %2").arg(least).arg(most_sweep_steps)
                                          : tr("a positive number"),
                                 option, word));
  return *number;
}

Evolution_order order_in(const QString& word, const Registry& registry) {
  const auto equals = word.indexOf(QLatin1Char('='));
  const QString id = word.left(equals);
  QStringList known;
  for (const Evolution_spec& spec : registry.evolutions()) known << QString::fromStdString(spec.id);
  if (equals < 0) throw Command_error(tr("record: expected --evolve ID=STEPS, found '%1'").arg(word));
  if (!known.contains(id)) throw Command_error(tr("record: unknown evolution '%1'").arg(id) + did_you_mean(id, known));
  return {id.toStdString(),
          static_cast<std::uint64_t>(number_in(QStringLiteral("--evolve"), word.mid(equals + 1), 1, true))};
}

}  // namespace

Record_order record_order(const QStringList& words, const Film_wish& usual, const Registry& registry) {
  Record_order order{usual, {}};
  QStringList options{QStringLiteral("--sweep"), QStringLiteral("--evolve"), QStringLiteral("--evolution"),
                      QStringLiteral("--fps"),   QStringLiteral("--size"),   QStringLiteral("--transparent")};
  if (registry.dimension() == 3) options << QStringLiteral("--turntable");
  std::optional<Source> source;
  const auto choose = [&](Source chosen) {
    if (source && *source != chosen)
      throw Command_error(tr("record: expected one of --sweep, --evolve, --evolution and --turntable, found two"));
    if (!source && chosen == Source::animation) order.wish.sweeps.clear();
    source = chosen;
  };
  for (qsizetype i = 0; i < words.size(); ++i) {
    const QString& option = words[i];
    const auto next = [&] {
      if (++i == words.size()) throw Command_error(tr("record: expected a value of %1, found nothing").arg(option));
      return words[i];
    };
    if (!options.contains(option))
      throw Command_error(tr("record: unknown OPTION '%1'").arg(option) + did_you_mean(option, options));
    if (option == QLatin1String("--sweep")) {
      choose(Source::animation);
      try {
        order.wish.sweeps.push_back(parse_sweep(registry, next().toStdString()));
      } catch (const std::invalid_argument& error) {
        throw Command_error(tr("record: --sweep %1: %2").arg(words[i], QString::fromUtf8(error.what())));
      }
    } else if (option == QLatin1String("--evolve")) {
      choose(Source::evolution);
      order.evolutions.push_back(order_in(next(), registry));
    } else if (option == QLatin1String("--evolution")) {
      choose(Source::evolution);
    } else if (option == QLatin1String("--turntable")) {
      choose(Source::turntable);
      order.wish.turntable = static_cast<int>(number_in(option, next(), 2, true));
    } else if (option == QLatin1String("--fps")) {
      order.wish.frames_per_second = number_in(option, next(), 1e-2, false);
    } else if (option == QLatin1String("--size")) {
      const auto size = pixels_in(next());
      if (!size)
        throw Command_error(tr("record: expected WIDTHxHEIGHT in pixels for --size, found '%1'").arg(words[i]));
      std::tie(order.wish.width, order.wish.height) = *size;
    } else {
      order.wish.is_transparent = true;
    }
  }
  order.wish.source = source.value_or(usual.source);
  return order;
}

Command record_command(const Registry& registry, std::function<Film_wish()> usual,
                       std::function<void(const Record_order&)> run) {
  const QString options =
      registry.dimension() == 3
          ? tr("as on the command line: --sweep ID=FROM:TO:STEPS, --evolve ID=STEPS or --turntable FRAMES, or "
               "--evolution "
               "for the steps that there are; --fps N, --size WxH, --transparent; else what the panel says")
          : tr("as on the command line: --sweep ID=FROM:TO:STEPS or --evolve ID=STEPS, or --evolution for the steps "
               "that "
               "there are; --fps N, --size WxH, --transparent; else what the panel says");
  return {QStringLiteral("record"),
          tr("Record a film"),
          tr("Films an animated setting, an evolution or, in space, a turntable, or begins a film of what changes"),
          tr("Record"),
          {{QStringLiteral("FILE"), tr("NAME.mp4, .webm, .gif or numbered pictures, NAME-%05d.png")},
           {QStringLiteral("OPTION"), options, Parameter::Kind::text, Parameter::Count::any}},
          [&registry, usual = std::move(usual), run = std::move(run)](const Arguments& arguments) {
            Record_order order = record_order(arguments.all(1), usual(), registry);
            order.wish.file = QFileInfo(arguments.word(0)).absoluteFilePath().toStdString();
            run(order);
          },
          true};
}

}  // namespace mesecina
