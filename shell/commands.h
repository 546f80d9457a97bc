// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>
#include <functional>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "shell/actions.h"

namespace mesecina {

/// Why a command cannot be carried out, in one line: what was expected, what was found, what is near to it.
class Command_error : public std::runtime_error {
 public:
  explicit Command_error(const QString& text) : std::runtime_error(text.toStdString()) {}
};

/// One argument of a command.
struct Parameter {
  enum class Kind { text, number, whole, size, flag };
  enum class Count { one, optional, any, some };  ///< some: one at least

  QString name;  ///< in capitals; of a flag: the word itself
  QString help;
  Kind kind = Kind::text;
  Count count = Count::one;
  std::function<QStringList()> known{};                     ///< the only words allowed; absent: any
  double least = -std::numeric_limits<double>::infinity();  ///< of numbers
};

/// The arguments of a command, checked against its parameters.
class Arguments {
 public:
  explicit Arguments(std::vector<QStringList> words) : words_(std::move(words)) {}

  bool has(std::size_t parameter) const { return !words_[parameter].isEmpty(); }
  const QStringList& all(std::size_t parameter) const { return words_[parameter]; }
  const QString& word(std::size_t parameter) const { return words_[parameter].front(); }
  double number(std::size_t parameter, double otherwise = 0) const;
  int whole(std::size_t parameter, int otherwise = 0) const;
  /// Width and height.
  std::pair<int, int> size(std::size_t parameter) const;

 private:
  std::vector<QStringList> words_;  ///< by parameter
};

/// What can be done by a line of text.
struct Command {
  QString id;    ///< kebab-case
  QString name;  ///< a few words
  QString help;  ///< a sentence
  QString group;
  std::vector<Parameter> parameters;
  /// Throws Command_error.
  std::function<void(const Arguments&)> run;
  bool needs_pictures = false;  ///< everything visible must be computed first

  /// "export-picture FILE [WxH] [transparent]"
  QString usage() const;
  /// The same without the id.
  QString arguments_text() const;
};

/// Everything that a line of text can do in a window: each action by its id, and commands with arguments. A command may
/// have the id of an action that would ask the user for what it takes as arguments; then lines mean the command.
class Commands {
 public:
  explicit Commands(const Actions& actions) : actions_(actions) {}

  /// Throws std::logic_error when a command has this id.
  void add(Command command);
  /// All of them, actions and commands, by groups in the order in which these came first.
  std::vector<Command> list() const;
  /// Throws Command_error, naming the nearest id, for an unknown one.
  Command find(const QString& id) const;
  /// Carries out `words`: an id and arguments. Throws Command_error.
  void run(const QStringList& words) const;
  const Actions& actions() const { return actions_; }

 private:
  Command command_of(const Actions::Entry& entry) const;

  const Actions& actions_;
  std::vector<Command> commands_;
};

/// The words of a line: blanks separate, "..." and '...' keep words together, in "..." a backslash takes the next
/// character as it is, a word that begins with # begins a comment. Throws Command_error for an open quotation.
QStringList words_of_line(const QString& line);
/// Width and height in "WxH", from 1 to 32768 pixels; nullopt for other words.
std::optional<std::pair<int, int>> pixels_in(const QString& word);
/// A word as words_of_line reads it back.
QString quoted(const QString& word);

/// "; did you mean 'x'?", or nothing when no name is near.
QString did_you_mean(const QString& word, const QStringList& known);

/// Text of --list commands.
std::string commands_text(const Commands& commands, bool as_json);

}  // namespace mesecina
