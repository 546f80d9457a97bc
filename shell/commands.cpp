// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/commands.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "core/formats/number.h"
#include "core/registry.h"

namespace mesecina {

namespace {

QString tr(const char* text) { return QCoreApplication::translate("commands", text); }

std::optional<double> number_in(const QString& word) {
  const auto number = parse_number(word.toStdString());
  return number && std::isfinite(*number) ? number : std::nullopt;
}

QString expected(const Parameter& parameter) {
  switch (parameter.kind) {
    case Parameter::Kind::number:
      return std::isfinite(parameter.least) ? tr("a number of %1 or more").arg(parameter.least) : tr("a number");
    case Parameter::Kind::whole:
      return std::isfinite(parameter.least) ? tr("a whole number of %1 or more").arg(parameter.least)
                                            : tr("a whole number");
    case Parameter::Kind::size:
      return tr("WIDTHxHEIGHT in pixels, from 1 to 32768");
    default:
      return parameter.name;
  }
}

bool is_good(const Parameter& parameter, const QString& word) {
  switch (parameter.kind) {
    case Parameter::Kind::number: {
      const auto number = number_in(word);
      return number && *number >= parameter.least;
    }
    case Parameter::Kind::whole: {
      const auto number = number_in(word);
      constexpr double most = std::numeric_limits<int>::max();
      return number && *number == std::floor(*number) && std::abs(*number) <= most && *number >= parameter.least;
    }
    case Parameter::Kind::size:
      return pixels_in(word).has_value();
    default:
      return true;
  }
}

void check(const Command& command, const Parameter& parameter, const QString& word) {
  if (!is_good(parameter, word))
    throw Command_error(
        tr("%1: expected %2 for %3, found '%4'").arg(command.id, expected(parameter), parameter.name, word));
  if (!parameter.known) return;
  const QStringList known = parameter.known();
  if (known.contains(word)) return;
  constexpr qsizetype few = 12;
  const QString near = did_you_mean(word, known);
  throw Command_error(tr("%1: unknown %2 '%3'").arg(command.id, parameter.name, word) +
                      (near.isEmpty() && known.size() <= few
                           ? tr("; expected one of %1").arg(known.join(QStringLiteral(", ")))
                           : near));
}

bool takes_several(const Parameter& parameter) {
  return parameter.count == Parameter::Count::any || parameter.count == Parameter::Count::some;
}

bool is_needed(const Parameter& parameter) {
  return parameter.kind != Parameter::Kind::flag &&
         (parameter.count == Parameter::Count::one || parameter.count == Parameter::Count::some);
}

/// The words of each parameter, in their order; what later parameters need is left to them.
Arguments checked(const Command& command, QStringList words) {
  const QString given = words.join(QLatin1Char(' '));
  std::vector<QStringList> by_parameter(command.parameters.size());
  for (std::size_t i = 0; i < command.parameters.size(); ++i) {
    const Parameter& flag = command.parameters[i];
    if (flag.kind == Parameter::Kind::flag && words.removeAll(flag.name) > 0) by_parameter[i] << flag.name;
  }
  for (std::size_t i = 0; i < command.parameters.size(); ++i) {
    const Parameter& parameter = command.parameters[i];
    if (parameter.kind == Parameter::Kind::flag) continue;
    const auto later = std::count_if(command.parameters.begin() + static_cast<std::ptrdiff_t>(i) + 1,
                                     command.parameters.end(), is_needed);
    const qsizetype spare = words.size() - later;
    const qsizetype taken = takes_several(parameter) ? spare : std::min<qsizetype>(spare, 1);
    if (taken <= 0) {
      if (is_needed(parameter))
        throw Command_error(given.isEmpty()
                                ? tr("%1: expected %2, found nothing").arg(command.id, command.arguments_text())
                                : tr("%1: expected %2, found '%3'").arg(command.id, command.arguments_text(), given));
      continue;
    }
    by_parameter[i] = words.mid(0, taken);
    words = words.mid(taken);
    for (const QString& word : by_parameter[i]) check(command, parameter, word);
  }
  if (!words.isEmpty())
    throw Command_error(
        tr("%1: expected nothing more, found '%2'; usage: %3").arg(command.id, words.front(), command.usage()));
  return Arguments(std::move(by_parameter));
}

const char* kind_name(Parameter::Kind kind) {
  constexpr const char* names[] = {"text", "number", "integer", "size", "flag"};
  return names[static_cast<std::size_t>(kind)];
}

}  // namespace

std::optional<std::pair<int, int>> pixels_in(const QString& word) {
  const QStringList parts = word.split(QLatin1Char('x'));
  if (parts.size() != 2) return {};
  constexpr int most_pixels = 32768;
  bool is_width = false;
  bool is_height = false;
  const int width = parts[0].toInt(&is_width);
  const int height = parts[1].toInt(&is_height);
  const auto is_good = [](int pixels) { return pixels >= 1 && pixels <= most_pixels; };
  if (!is_width || !is_height || !is_good(width) || !is_good(height)) return {};
  return std::pair(width, height);
}

double Arguments::number(std::size_t parameter, double otherwise) const {
  return has(parameter) ? number_in(word(parameter)).value_or(otherwise) : otherwise;
}

int Arguments::whole(std::size_t parameter, int otherwise) const {
  return static_cast<int>(number(parameter, otherwise));
}

std::pair<int, int> Arguments::size(std::size_t parameter) const { return pixels_in(word(parameter)).value(); }

QString Command::arguments_text() const {
  QStringList texts;
  for (const Parameter& parameter : parameters) {
    const QString text = is_needed(parameter) ? parameter.name : QStringLiteral("[%1]").arg(parameter.name);
    texts << (takes_several(parameter) ? text + QStringLiteral("...") : text);
  }
  return texts.join(QLatin1Char(' '));
}

QString Command::usage() const { return parameters.empty() ? id : id + QLatin1Char(' ') + arguments_text(); }

void Commands::add(Command command) {
  if (std::ranges::find(commands_, command.id, &Command::id) != commands_.end())
    throw std::logic_error("command id is taken: " + command.id.toStdString());
  commands_.push_back(std::move(command));
}

Command Commands::command_of(const Actions::Entry& entry) const {
  QAction* action = entry.action;
  Command command{action->objectName(), entry.name, action->statusTip(), entry.group, {}, {}};
  if (action->isCheckable()) {
    command.parameters.push_back({QStringLiteral("on|off"), tr("nothing: the other of the two"), Parameter::Kind::text,
                                  Parameter::Count::optional, [] {
                                    return QStringList{QStringLiteral("on"), QStringLiteral("off")};
                                  }});
  }
  command.run = [action](const Arguments& arguments) {
    if (!action->isEnabled()) throw Command_error(tr("%1: not possible now").arg(action->objectName()));
    const bool is_as_wanted =
        action->isCheckable() && arguments.has(0) && action->isChecked() == (arguments.word(0) == QLatin1String("on"));
    if (!is_as_wanted) action->trigger();
  };
  return command;
}

std::vector<Command> Commands::list() const {
  std::vector<Command> list;
  for (const Actions::Entry& entry : actions_.entries()) {
    if (std::ranges::find(commands_, entry.action->objectName(), &Command::id) == commands_.end())
      list.push_back(command_of(entry));
  }
  list.insert(list.end(), commands_.begin(), commands_.end());
  QStringList groups;
  for (const Command& command : list)
    if (!groups.contains(command.group)) groups << command.group;
  std::ranges::stable_sort(list, {}, [&](const Command& command) { return groups.indexOf(command.group); });
  return list;
}

Command Commands::find(const QString& id) const {
  const auto it = std::ranges::find(commands_, id, &Command::id);
  if (it != commands_.end()) return *it;
  if (const Actions::Entry* entry = actions_.find(id)) return command_of(*entry);
  QStringList known;
  for (const Command& command : list()) known << command.id;
  const QString near = did_you_mean(id, known);
  throw Command_error(tr("unknown command '%1'").arg(id) +
                      (near.isEmpty() ? tr("; --list commands shows them all") : near));
}

void Commands::run(const QStringList& words) const {
  if (words.isEmpty()) return;
  const Command command = find(words.front());
  command.run(checked(command, words.mid(1)));
}

QStringList words_of_line(const QString& line) {
  QStringList words;
  QString word;
  bool is_word = false;
  QChar quotation;
  for (qsizetype i = 0; i < line.size(); ++i) {
    const QChar letter = line[i];
    if (!quotation.isNull()) {
      if (letter == quotation) {
        quotation = QChar();
      } else if (letter == QLatin1Char('\\') && quotation == QLatin1Char('"') && i + 1 < line.size()) {
        word += line[++i];
      } else {
        word += letter;
      }
    } else if (letter == QLatin1Char('"') || letter == QLatin1Char('\'')) {
      quotation = letter;
      is_word = true;
    } else if (letter.isSpace()) {
      if (is_word) words << std::exchange(word, {});
      is_word = false;
    } else if (letter == QLatin1Char('#') && !is_word) {
      break;
    } else {
      word += letter;
      is_word = true;
    }
  }
  if (!quotation.isNull()) throw Command_error(tr("expected a closing %1, found the end of the line").arg(quotation));
  if (is_word) words << word;
  return words;
}

QString quoted(const QString& word) {
  const bool is_plain =
      !word.isEmpty() && !word.startsWith(QLatin1Char('#')) && std::ranges::none_of(word, [](QChar letter) {
        return letter.isSpace() || letter == QLatin1Char('"') || letter == QLatin1Char('\'');
      });
  if (is_plain) return word;
  QString text = word;
  text.replace(QLatin1Char('\\'), QStringLiteral("\\\\")).replace(QLatin1Char('"'), QStringLiteral("\\\""));
  return QStringLiteral("\"%1\"").arg(text);
}

QString did_you_mean(const QString& word, const QStringList& known) {
  std::vector<std::string> names;
  for (const QString& name : known) names.push_back(name.toStdString());
  const std::string near = nearest_name(word.toStdString(), names);
  return near.empty() ? QString() : tr("; did you mean '%1'?").arg(QString::fromStdString(near));
}

std::string commands_text(const Commands& commands, bool as_json) {
  const auto keys_of = [&](const Command& command) {
    const Actions::Entry* entry = commands.actions().find(command.id);
    return entry ? entry->action->shortcuts() : QList<QKeySequence>();
  };
  if (as_json) {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const Command& command : commands.list()) {
      nlohmann::ordered_json entry{{"id", command.id.toStdString()},
                                   {"name", command.name.toStdString()},
                                   {"group", command.group.toStdString()},
                                   {"usage", command.usage().toStdString()},
                                   {"help", command.help.toStdString()}};
      auto keys = nlohmann::ordered_json::array();
      for (const QKeySequence& sequence : keys_of(command))
        keys.push_back(sequence.toString(QKeySequence::PortableText).toStdString());
      entry["keys"] = std::move(keys);
      auto parameters = nlohmann::ordered_json::array();
      for (const Parameter& parameter : command.parameters)
        parameters.push_back({{"name", parameter.name.toStdString()},
                              {"type", kind_name(parameter.kind)},
                              {"needed", is_needed(parameter)},
                              {"several", takes_several(parameter)},
                              {"help", parameter.help.toStdString()}});
      entry["parameters"] = std::move(parameters);
      list.push_back(std::move(entry));
    }
    return list.dump(2) + "\n";
  }
  QString text;
  QString group;
  constexpr qsizetype help_column = 34;
  for (const Command& command : commands.list()) {
    if (command.group != group) text += (text.isEmpty() ? QString() : QStringLiteral("\n")) + command.group + '\n';
    group = command.group;
    const QString keys = QKeySequence::listToString(keys_of(command), QKeySequence::PortableText);
    text += QStringLiteral("  ") + command.usage().leftJustified(help_column) + QStringLiteral("  ") + command.help +
            (keys.isEmpty() ? QString() : QStringLiteral(" [%1]").arg(keys)) + '\n';
  }
  return text.toStdString();
}

}  // namespace mesecina
