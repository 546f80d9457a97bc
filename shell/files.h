// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QSize>
#include <QString>
#include <QStringList>
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "core/formats/film.h"
#include "core/formats/format.h"
#include "core/session.h"
#include "core/style.h"
#include "shell/background_jobs.h"
#include "shell/document.h"
#include "shell/message_bar.h"

class QWidget;

namespace mesecina {

/// What files are about in one program.
struct Files_of_program {
  QString program;  ///< that remembers the last folder ("mesecina2d")
  int dimension = 2;
  /// The first inputs with the second ones added.
  std::function<Inputs(const Inputs&, const Inputs&)> appended;
  /// In the user's words ("points").
  std::function<QString(const std::string& input_id)> part_name;
};

/// How files of sessions reach a window.
struct Scene_of_window {
  /// Everything there is now, for a file.
  std::function<Session()> session;
  std::function<Document_state(const Session&)> state;
};

/// A frame as a picture of this size in pixels. Throws File_error.
void write_picture(const Picture_writer& writer, const std::filesystem::path& file, const Film_frame& frame,
                   const QSize& size);

/// Brings files into the document and out of it. Reading and exporting happen on another thread.
class Files : public QObject {
  Q_OBJECT
 public:
  /// `window` is the parent of the file choosers.
  Files(Document& document, std::shared_ptr<const Formats> formats, Files_of_program kinds, QWidget* window);

  /// Replaces the inputs by what the files hold, or adds it to them: one step that can be undone. A bad file changes
  /// nothing and is told in one line.
  void open(const QStringList& paths, bool is_added);
  /// Replaces everything by what a session, or a picture with one within, holds; another file is told as an error.
  void open_session(const QString& path);
  /// As open(), for the files that a window starts with: there is nothing before them that one could go back to, unless
  /// the user has begun to edit meanwhile.
  void open_first(const QStringList& paths);
  /// Opens a file that is not the user's: it is not remembered, and saving asks for another name.
  void open_example(const QString& path);
  /// Without it, sessions can be neither opened nor saved.
  void set_scene(Scene_of_window scene) { scene_ = std::move(scene); }
  /// Shows a session that no file of the user's holds, in one step that can be undone; at a start there is nothing
  /// before it that one could go back to.
  void show_session(const Session& session, const QString& step, bool is_start);
  void new_document();
  /// Says that the document is the example of a first start.
  void name_example() { set_current({}, tr("Example")); }

  // What saves begins to: the file is written on another thread, as the data is now, and is complete on the disk, or
  // not there, whatever happens. The document counts as saved when it is there; else a message says why not.

  /// Into the file of the document, if there is one that can hold everything, else asks. False when the user gave up.
  bool save();
  /// False, with a message, also when there is more than any one file can hold.
  bool save_as();
  /// By the extension. False, with a message, when the file cannot hold everything there is.
  bool save_to(const QString& path);
  /// Everything there is, as a session, into a file that is asked for.
  bool save_session_as();
  bool save_session_to(const QString& path);
  /// Only the input of this id.
  bool save_part_as(const std::string& input_id);
  bool save_part_to(const QString& path, const std::string& input_id);

  /// Paints it in this size in pixels, with the writer of the path's extension, on the other thread.
  void export_picture(const QString& path, Film_frame frame, const QSize& size);
  /// Whether sessions are put into pictures, so that opening one brings everything back; not where that is too large.
  void set_scenes_in_pictures(bool is_on) { has_scenes_in_pictures_ = is_on; }
  /// One file per visible layer and format, named as those of --nogui: STEM.LAYER.EXTENSION.
  void export_layers(const QString& folder, const Scene& scene, const std::vector<std::string>& formats,
                     const std::map<std::string, Setting_value>& settings,
                     const std::map<std::string, QString>& reasons);

  /// Asks the user for files to open.
  void choose_and_open(bool is_added);
  /// Empty when the user gave up. `filters` as for QFileDialog.
  QString choose_for_writing(const QString& title, const QString& suggestion, const QString& filters);
  /// Empty when the user gave up. `filters` as for QFileDialog.
  QString choose_for_reading(const QString& title, const QString& filters);
  QString choose_folder(const QString& title);

  /// Something is being saved, which must not be cut short.
  bool is_saving() const { return saving_.is_busy(); }
  const Background_jobs& saving() const { return saving_; }
  /// Waits for it, for this long at most; the window goes on, but takes nothing of the user. False where it takes
  /// longer.
  bool finish_saving(std::chrono::milliseconds bound);
  /// What reads and exports, and can be cancelled.
  Background_jobs& jobs() { return jobs_; }
  const Background_jobs& jobs() const { return jobs_; }
  /// Of the document; empty for none.
  const QString& current_file() const { return current_file_; }
  /// "giraffe.wkt" or "Untitled"
  QString title() const;
  QString stem() const;

 Q_SIGNALS:
  void told(mesecina::Message_bar::Kind kind, const QString& line);
  void opened(const QString& path);
  /// The inputs were replaced or joined by what files held.
  void loaded(bool is_added);
  /// Everything was replaced by what a session holds; its view is not shown yet.
  void session_opened(const mesecina::Session& session);
  void title_changed();

 private:
  struct Loaded;
  struct Order;
  void read(const Order& order);
  void take(const Loaded& result);
  const Input_writer* writer_for(const QString& path, const std::string& input_id) const;
  static QString session_filter();
  QString filters_for(const std::vector<std::string>& input_ids) const;
  std::vector<std::string> parts() const;
  void write(const QString& path, const Input_writer& writer, bool names_document);
  void begin_saving(const QString& path, const std::function<void(std::ostream&)>& write,
                    const std::function<void()>& mark_saved, bool names_document);
  void name(const QString& file, const QString& title);
  void take_session(const Loaded& result);
  void set_current(const QString& file, const QString& title);
  QString last_folder() const;
  void remember_folder(const QString& path);

  Document& document_;
  std::shared_ptr<const Formats> formats_;
  Files_of_program kinds_;
  QWidget* window_;
  Scene_of_window scene_;
  bool has_scenes_in_pictures_ = true;
  QString current_file_;
  QString title_;
  std::uint64_t document_number_ = 0;  ///< of what was opened, so that saving does not name what came later
  Background_jobs jobs_;
  Background_jobs saving_;
};

}  // namespace mesecina
