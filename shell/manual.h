// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QMap>
#include <QString>
#include <QStringList>
#include <filesystem>
#include <functional>
#include <memory>
#include <utility>
#include <variant>
#include <vector>

#include "core/batch/command_line.h"
#include "core/formats/format.h"
#include "core/registry.h"
#include "shell/commands.h"

namespace mesecina {

/// A picture of the manual, which the program makes: of an example, or of a window after a script.
struct Manual_figure {
  QString name;          ///< kebab-case; of the file
  QString input;         ///< name of an example; empty for a picture of a window
  QStringList options;   ///< of the command line, without --nogui and the input
  QStringList commands;  ///< of the script for a picture of a window, which is taken after them
  QString caption;

  bool is_of_window() const { return !commands.isEmpty(); }
  /// What it was made by, in one line: pictures carry it, so that those of older figures are told from new ones.
  QString recipe() const;
};

/// The key of the text in a picture that holds the recipe.
inline constexpr const char* recipe_key = "mesecina-figure";

/// A part of a page below a heading.
struct Manual_section {
  QString page;
  QString anchor;  ///< within the page
  QString title;
  QString text;  ///< without tags, for searching
};

struct Manual_page {
  QString id;     ///< kebab-case
  QString title;  ///< a few words
  QString body;   ///< HTML; links are "layer:ID", "setting:ID", "evolution:ID", "command:ID", "option:--NAME",
                  ///< "chapter:ID" or of the web
};

/// What the manual is about.
struct Manual_subject {
  QString program;  ///< "mesecina2d"
  const Registry& registry;
  const Formats& formats;
  const Commands* commands;  ///< null where only the figures are wanted: nothing is said of commands then
};

/// The manual of a program: chapters written by hand, then what the registries say of layers, settings, evolutions,
/// commands, formats and options, so that nothing is missing there and nothing is stale.
class Manual {
 public:
  explicit Manual(const Manual_subject& subject);

  const std::vector<Manual_page>& pages() const { return pages_; }
  const std::vector<Manual_section>& sections() const { return sections_; }
  const std::vector<Manual_figure>& figures() const { return figures_; }
  const Manual_figure* find_figure(const QString& name) const;
  /// Page and anchor that a link leads to; empty for an unknown one and for the web.
  std::pair<QString, QString> target(const QString& link) const;
  /// The body as a file among others: links lead to files, and figures show their pictures.
  QString file_body(const Manual_page& page) const;
  /// The body for a window: figures are pictures this wide, in pixels, and links "figure:NAME".
  QString window_body(const Manual_page& page, int picture_width) const;
  /// The picture that comes with the program, a resource. scripts/make-manual-pictures makes it.
  QString shipped_picture(const QString& figure) const;
  /// One sentence for each link that leads nowhere, each figure that could not be made, and each picture that is
  /// missing or was made by another recipe. For tests.
  QStringList faults() const;

 private:
  void add_chapters();
  /// As windows say it, for HTML.
  QString help_of(const std::string& help) const;
  void add_layers();
  void add_settings();
  void add_evolutions();
  void add_commands();
  void add_formats();
  void add_options();
  void add_page(const QString& id, const QString& title, const QString& body);

  Manual_subject subject_;
  std::vector<Manual_page> pages_;
  std::vector<Manual_section> sections_;
  std::vector<Manual_figure> figures_;
  QMap<QString, QString> anchors_;  ///< page by link
};

/// What these arguments, without the name of the program, are to the program.
std::variant<Command_line, Early_exit> parsed_arguments(const Manual_subject& subject, const QStringList& arguments);

/// The lines of a script that shows in the window what a figure shows.
QString figure_script(const Manual_figure& figure);

/// Makes the pictures of the figures, pictures/NAME.png in a folder, which is made where there is none, and writes the
/// inputs that they and the commands of the chapters are about into its folder "examples". `write_example` writes the
/// input of this name into a file of this name in a folder. Computes in child processes (see run_batch). Pictures of
/// windows, which need a display, are those that come with the program. False, with a line on stderr, when some picture
/// could not be made.
bool make_manual_pictures(const Manual_subject& subject, const std::shared_ptr<const Registry>& registry,
                          const std::filesystem::path& folder,
                          const std::function<void(const QString& name, const QString& folder)>& write_example);

/// Writes the pages into a folder, which is made where there is none: index.html, ID.html, manual.css. Pictures are
/// expected in its folder "pictures". Throws File_error.
void write_manual(const Manual& manual, const std::filesystem::path& folder);

}  // namespace mesecina
