// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/files.h"

#include <QDir>
#include <QEventLoop>
#include <QFile>
#include <QFileDialog>
#include <QFileInfo>
#include <QTemporaryDir>
#include <QTimer>
#include <algorithm>
#include <utility>

#include "core/formats/durable_file.h"
#include "core/formats/picture_scene.h"
#include "shell/preferences.h"

namespace mesecina {

namespace {

constexpr QLatin1String folder_key("last-folder");

QString message_of(const std::exception& error) { return QString::fromUtf8(error.what()); }

bool is_session_file(const QString& path) {
  return QFileInfo(path).suffix().toLower().toStdString() == session_extension;
}

QString name_of(const QStringList& paths) {
  return paths.size() == 1 ? QFileInfo(paths.front()).fileName() : Files::tr("%1 files").arg(paths.size());
}

}  // namespace

struct Files::Order {
  QStringList paths;
  QString step;  ///< for undo
  bool is_added = false;
  bool is_example = false;
  bool is_first = false;
  bool needs_session = false;
};

struct Files::Loaded {
  Order order;
  Inputs inputs;
  std::shared_ptr<const Session> session;  ///< of the only file, where that holds one
  QStringList good;
  QStringList errors;
  QStringList warnings;
};

Files::Files(Document& document, std::shared_ptr<const Formats> formats, Files_of_program kinds, QWidget* window)
    : QObject(window), document_(document), formats_(std::move(formats)), kinds_(std::move(kinds)), window_(window) {}

QString Files::title() const { return title_.isEmpty() ? tr("Untitled") : title_; }

QString Files::stem() const { return title_.isEmpty() ? tr("untitled") : QFileInfo(title_).completeBaseName(); }

void Files::set_current(const QString& file, const QString& title) {
  ++document_number_;
  name(file, title);
}

void Files::name(const QString& file, const QString& title) {
  current_file_ = file;
  title_ = title;
  Q_EMIT title_changed();
}

void Files::open(const QStringList& paths, bool is_added) {
  if (paths.isEmpty()) return;
  remember_folder(paths.front());
  read({paths, is_added ? tr("Add %1").arg(name_of(paths)) : tr("Open %1").arg(name_of(paths)), is_added});
}

void Files::open_session(const QString& path) {
  remember_folder(path);
  Order order{{path}, tr("Open %1").arg(name_of({path}))};
  order.needs_session = true;
  read(order);
}

void Files::open_first(const QStringList& paths) {
  remember_folder(paths.front());
  read({paths, tr("Open %1").arg(name_of(paths)), false, false, true});
}

void Files::open_example(const QString& path) {
  read({{path}, tr("Open the example %1").arg(QFileInfo(path).fileName()), false, true});
}

void Files::new_document() {
  document_.replace_inputs({}, tr("New"));
  document_.mark_all_saved();
  set_current({}, {});
}

void Files::read(const Order& order) {
  if (is_saving()) {
    // What is being written may be what is to be read.
    connect(
        &saving_, &Background_jobs::idle, this, [this, order] { read(order); }, Qt::SingleShotConnection);
    return;
  }
  jobs_.run(tr("Reading %1").arg(name_of(order.paths)),
            [this, formats = formats_, appended = kinds_.appended, order]() -> std::function<void()> {
              Loaded loaded;
              loaded.order = order;
              const QTemporaryDir folder;
              for (const QString& path : order.paths) {
                QString file = path;
                if (order.is_example) {
                  file = folder.filePath(QFileInfo(path).fileName());
                  QFile::copy(path, file);
                }
                try {
                  const File_contents contents = read_file(*formats, file.toStdString());
                  loaded.inputs = appended(loaded.inputs, contents.inputs);
                  if (order.paths.size() == 1 && !order.is_added) loaded.session = contents.session;
                  loaded.good << path;
                  for (const std::string& warning : contents.warnings)
                    loaded.warnings << tr("%1: %2").arg(QFileInfo(path).fileName(), QString::fromStdString(warning));
                } catch (const std::exception& error) {
                  loaded.errors << message_of(error);
                }
              }
              return [this, loaded = std::move(loaded)] { take(loaded); };
            });
}

void Files::take(const Loaded& result) {
  for (const QString& error : result.errors) Q_EMIT told(Message_bar::Kind::error, error);
  for (const QString& warning : result.warnings) Q_EMIT told(Message_bar::Kind::warning, warning);
  if (result.good.isEmpty()) return;
  if (result.order.needs_session && !result.session) {
    Q_EMIT told(Message_bar::Kind::error, tr("%1: expected a session, or a picture with one within, found other data; "
                                             "open it as a file of data")
                                              .arg(result.good.front()));
    return;
  }
  if (result.session && scene_.state) {
    take_session(result);
    return;
  }
  const Order& order = result.order;
  const bool is_start = order.is_first && document_.history().count() == 0;
  if (order.is_added) {
    document_.edit_inputs(kinds_.appended(document_.inputs(), result.inputs), order.step);
  } else {
    document_.replace_inputs(result.inputs, order.step);
  }
  if (is_start) document_.history().clear();
  if (!order.is_added) {
    document_.mark_all_saved();
    const bool is_one_file = result.good.size() == 1 && !order.is_example;
    set_current(is_one_file ? QFileInfo(result.good.front()).absoluteFilePath() : QString(), name_of(result.good));
  }
  if (!order.is_example)
    for (const QString& path : result.good) Q_EMIT opened(path);
  Q_EMIT loaded(order.is_added);
}

void Files::take_session(const Loaded& result) {
  const Order& order = result.order;
  show_session(*result.session, order.step, order.is_first);
  const QString& path = result.good.front();
  // A picture shows a scene, but saving goes on in the file of the data.
  if (is_session_file(path)) {
    document_.mark_scene_saved();
    set_current(QFileInfo(path).absoluteFilePath(), QFileInfo(path).fileName());
  }
  if (!order.is_example) Q_EMIT opened(path);
}

void Files::show_session(const Session& session, const QString& step, bool is_start) {
  const bool is_untouched = is_start && document_.history().count() == 0;
  document_.edit(scene_.state(session), step);
  if (is_untouched) document_.history().clear();
  set_current(QString::fromStdString(session.file), QString::fromStdString(session.title));
  if (!session.is_modified && is_session_file(current_file_)) document_.mark_scene_saved();
  if (!session.is_modified && !is_session_file(current_file_)) document_.mark_all_saved();
  Q_EMIT session_opened(session);
}

std::vector<std::string> Files::parts() const {
  std::vector<std::string> parts;
  // Pictures stay as they were read; what evolutions keep for themselves is no data.
  for (const std::string& id : document_.inputs().ids())
    if (std::ranges::any_of(formats_->input_writers, [&](const auto& writer) { return writer.input_id == id; }))
      parts.push_back(id);
  return parts;
}

const Input_writer* Files::writer_for(const QString& path, const std::string& input_id) const {
  const std::string extension = QFileInfo(path).suffix().toLower().toStdString();
  const auto it = std::ranges::find_if(formats_->input_writers, [&](const Input_writer& writer) {
    return writer.extension == extension && writer.input_id == input_id;
  });
  return it == formats_->input_writers.end() ? nullptr : &*it;
}

QString Files::filters_for(const std::vector<std::string>& input_ids) const {
  QStringList filters;
  for (const std::string& id : input_ids) {
    for (const Input_writer& writer : formats_->input_writers) {
      if (writer.input_id != id) continue;
      const QString extension = QString::fromStdString(writer.extension);
      filters << tr("%1 as %2 (*.%3)").arg(kinds_.part_name(id), extension.toUpper(), extension);
    }
  }
  return filters.join(QStringLiteral(";;"));
}

bool Files::save() {
  if (is_session_file(current_file_)) return save_session_to(current_file_);
  if (!current_file_.isEmpty()) {
    const auto ids = parts();
    if (ids.size() == 1 && writer_for(current_file_, ids.front())) return save_to(current_file_);
  }
  return save_as();
}

bool Files::save_as() {
  const auto ids = parts();
  if (ids.empty()) {
    Q_EMIT told(Message_bar::Kind::note, tr("There is nothing to save yet."));
    return false;
  }
  QStringList filters;
  if (ids.size() > 1) {
    QStringList names;
    for (const std::string& id : ids) names << kinds_.part_name(id);
    Q_EMIT told(Message_bar::Kind::note, tr("No file of data holds the %1 together; a session does, and File ▸ Save a "
                                            "part saves them one by one")
                                             .arg(names.join(tr(" and "))));
  }
  if (scene_.session) filters << session_filter();
  if (ids.size() == 1 || filters.isEmpty()) filters << filters_for(ids);
  const QString path = choose_for_writing(tr("Save"), stem(), filters.join(QStringLiteral(";;")));
  return !path.isEmpty() && save_to(path);
}

QString Files::session_filter() { return tr("Session: data, layers, settings and view (*.mesecina)"); }

bool Files::save_session_as() {
  const QString path = choose_for_writing(tr("Save session"), stem(), session_filter());
  return !path.isEmpty() && save_session_to(path);
}

bool Files::save_session_to(const QString& path) {
  auto session = std::make_shared<Session>(scene_.session());
  // What is in the session's file is named by it.
  session->title = QFileInfo(path).fileName().toStdString();
  session->file.clear();
  session->is_modified = false;
  for (const std::string& id : without_form(session->inputs))
    Q_EMIT told(Message_bar::Kind::warning,
                tr("%1 cannot hold the %2, which are left out").arg(path, kinds_.part_name(id)));
  begin_saving(
      path, [session](std::ostream& stream) { stream << to_json(*session); },
      [this, state = document_.state()] { document_.mark_scene_saved(state); }, true);
  return true;
}

void Files::begin_saving(const QString& path, const std::function<void(std::ostream&)>& write,
                         const std::function<void()>& mark_saved, bool names_document) {
  remember_folder(path);
  // Undo stops at what is saved.
  document_.end_step();
  const auto take_success = [this, path, mark_saved, names_document, number = document_number_] {
    if (number == document_number_) {
      mark_saved();
      if (names_document) name(QFileInfo(path).absoluteFilePath(), QFileInfo(path).fileName());
    }
    Q_EMIT opened(path);
  };
  saving_.run(tr("Saving %1").arg(QFileInfo(path).fileName()),
              [this, path, write, take_success]() -> std::function<void()> {
                try {
                  write_file_durably(path.toStdString(), write);
                  return take_success;
                } catch (const std::exception& error) {
                  return [this, text = message_of(error)] { Q_EMIT told(Message_bar::Kind::error, text); };
                }
              });
}

bool Files::finish_saving(std::chrono::milliseconds bound) {
  if (!is_saving()) return true;
  QEventLoop loop;
  connect(&saving_, &Background_jobs::idle, &loop, &QEventLoop::quit);
  QTimer::singleShot(bound, &loop, &QEventLoop::quit);
  loop.exec(QEventLoop::ExcludeUserInputEvents);
  return !is_saving();
}

bool Files::save_to(const QString& path) {
  if (scene_.session && is_session_file(path)) return save_session_to(path);
  const auto ids = parts();
  const Input_writer* writer = nullptr;
  QStringList lost;
  for (const std::string& id : ids) {
    const Input_writer* candidate = writer ? nullptr : writer_for(path, id);
    if (candidate) {
      writer = candidate;
    } else {
      lost << kinds_.part_name(id);
    }
  }
  const QString extension = QFileInfo(path).suffix();
  if (!writer) {
    Q_EMIT told(Message_bar::Kind::error,
                tr("%1: no file .%2 can hold the %3; expected one of %4")
                    .arg(path, extension, lost.join(tr(" and ")),
                         filters_for(ids).replace(QStringLiteral(";;"), QStringLiteral(", "))));
    return false;
  }
  if (!lost.isEmpty()) {
    Q_EMIT told(
        Message_bar::Kind::error,
        tr("%1: a file .%2 holds only the %3, and the %4 would be lost; save them one by one with File ▸ Save a "
           "part")
            .arg(path, extension, kinds_.part_name(writer->input_id), lost.join(tr(" and "))));
    return false;
  }
  write(path, *writer, true);
  return true;
}

bool Files::save_part_as(const std::string& input_id) {
  const auto ids = parts();
  if (std::ranges::find(ids, input_id) == ids.end()) {
    Q_EMIT told(Message_bar::Kind::note, tr("There are no %1 to save.").arg(kinds_.part_name(input_id)));
    return false;
  }
  const QString path =
      choose_for_writing(tr("Save %1").arg(kinds_.part_name(input_id)), stem(), filters_for({input_id}));
  return !path.isEmpty() && save_part_to(path, input_id);
}

bool Files::save_part_to(const QString& path, const std::string& input_id) {
  const Input_writer* writer = writer_for(path, input_id);
  if (writer) {
    write(path, *writer, false);
    return true;
  }
  Q_EMIT told(Message_bar::Kind::error,
              tr("%1: no file .%2 can hold the %3; expected one of %4")
                  .arg(path, QFileInfo(path).suffix(), kinds_.part_name(input_id),
                       filters_for({input_id}).replace(QStringLiteral(";;"), QStringLiteral(", "))));
  return false;
}

void Files::write(const QString& path, const Input_writer& writer, bool names_document) {
  const Inputs inputs = document_.inputs();
  begin_saving(
      path, [formats = formats_, &writer, inputs](std::ostream& stream) { writer.write(stream, inputs); },
      [this, id = writer.input_id, inputs] {
        document_.mark_saved({id, std::string(image_input.id)}, inputs);
      },
      names_document);
}

void write_picture(const Picture_writer& writer, const std::filesystem::path& file, const Film_frame& frame,
                   const QSize& size) {
  if (writer.write_3) {
    writer.write_3(file, frame.scene, frame.view_3, size.width(), size.height());
  } else {
    writer.write(file, frame.scene, frame.view, size.width(), size.height());
  }
}

void Files::export_picture(const QString& path, Film_frame frame, const QSize& size) {
  const Picture_writer* writer = formats_->find_picture_writer(QFileInfo(path).suffix().toLower().toStdString());
  if (!writer) {
    QStringList extensions;
    for (const Picture_writer& known : formats_->picture_writers)
      extensions << QStringLiteral(".") + QString::fromStdString(known.extension);
    Q_EMIT told(Message_bar::Kind::error,
                tr("%1: expected a name that ends in %2").arg(path, extensions.join(tr(" or "))));
    return;
  }
  remember_folder(path);
  std::shared_ptr<const Session> session;
  if (has_scenes_in_pictures_ && scene_.session) session = std::make_shared<const Session>(scene_.session());
  jobs_.run(tr("Writing %1").arg(QFileInfo(path).fileName()),
            [this, formats = formats_, writer, path, frame = std::move(frame), size,
             session = std::move(session)]() -> std::function<void()> {
              try {
                write_picture(*writer, path.toStdString(), frame, size);
                const std::string scene = session ? to_json(*session) : std::string();
                const bool is_too_large = scene.size() > most_scene_bytes;
                if (session && !is_too_large) add_scene_to_picture(path.toStdString(), scene);
                return [this, path, is_too_large] {
                  Q_EMIT told(Message_bar::Kind::note,
                              is_too_large
                                  ? tr("Wrote %1, without the scene, which is too large; save a session").arg(path)
                                  : tr("Wrote %1").arg(path));
                };
              } catch (const std::exception& error) {
                return [this, text = message_of(error)] { Q_EMIT told(Message_bar::Kind::error, text); };
              }
            });
}

void Files::export_layers(const QString& folder, const Scene& scene, const std::vector<std::string>& formats,
                          const std::map<std::string, Setting_value>& settings,
                          const std::map<std::string, QString>& reasons) {
  const auto work = [this, known = formats_, folder, layers = scene.layers, formats, settings, reasons,
                     file_stem = stem(), input = title(), dimension = kinds_.dimension]() -> std::function<void()> {
    int written = 0;
    QStringList empty_files;
    try {
      for (const Scene_layer& layer : layers) {
        if (!layer.style.visible) continue;
        const bool is_cut = layer.primitives && layer.cut;
        const auto cut = is_cut ? apply_cut(*layer.primitives, *layer.cut) : Primitive_set();
        const auto reason = reasons.find(layer.id);
        const Primitive_set* primitives = is_cut ? &cut : layer.primitives.get();
        Layer_document document{layer.id,
                                input.toStdString(),
                                settings,
                                primitives,
                                reason == reasons.end() ? std::string() : reason->second.toStdString(),
                                dimension};
        if (!primitives && document.reason.empty()) document.reason = "not computed";
        for (const std::string& name : formats) {
          const Layer_writer* writer = known->find_layer_writer(name);
          if (!writer) continue;
          const QString path =
              QStringLiteral("%1/%2.%3.%4")
                  .arg(folder, file_stem, QString::fromStdString(layer.id), QString::fromStdString(writer->extension));
          write_file(path.toStdString(), [&](std::ostream& stream) { writer->write(stream, document); });
          ++written;
          if (const std::string text = empty_file_text(*writer, primitives); !text.empty())
            empty_files << QStringLiteral("%1: %2").arg(path, QString::fromStdString(text));
        }
      }
    } catch (const std::exception& error) {
      return [this, text = message_of(error)] { Q_EMIT told(Message_bar::Kind::error, text); };
    }
    return [this, folder, written, empty_files] {
      for (const QString& line : empty_files) Q_EMIT told(Message_bar::Kind::warning, line);
      Q_EMIT told(Message_bar::Kind::note, tr("Wrote %1 files into %2").arg(written).arg(folder));
    };
  };
  remember_folder(folder + QLatin1Char('/'));
  jobs_.run(tr("Writing layers"), work);
}

void Files::choose_and_open(bool is_added) {
  QStringList every;
  QStringList filters;
  for (const Reader& reader : formats_->readers) {
    QStringList patterns;
    for (const std::string& extension : reader.extensions) patterns << QStringLiteral("*.") + extension.c_str();
    every << patterns;
    filters << QStringLiteral("%1 (%2)").arg(QString::fromStdString(reader.name), patterns.join(QLatin1Char(' ')));
  }
  filters.prepend(tr("All readable files (%1)").arg(every.join(QLatin1Char(' '))));
  filters << tr("All files (*)");
  open(QFileDialog::getOpenFileNames(window_, is_added ? tr("Add files") : tr("Open files"), last_folder(),
                                     filters.join(QStringLiteral(";;"))),
       is_added);
}

QString Files::choose_for_writing(const QString& title, const QString& suggestion, const QString& filters) {
  QFileDialog dialog(window_, title, last_folder());
  dialog.setAcceptMode(QFileDialog::AcceptSave);
  dialog.setNameFilters(filters.split(QStringLiteral(";;")));
  // So that the question before overwriting is about the file that will be written.
  const auto take_suffix = [&dialog](const QString& filter) {
    dialog.setDefaultSuffix(filter.section(QStringLiteral("*."), 1).chopped(1));
  };
  take_suffix(dialog.selectedNameFilter());
  connect(&dialog, &QFileDialog::filterSelected, &dialog, take_suffix);
  dialog.selectFile(suggestion);
  if (dialog.exec() != QDialog::Accepted || dialog.selectedFiles().isEmpty()) return {};
  return dialog.selectedFiles().front();
}

QString Files::choose_for_reading(const QString& title, const QString& filters) {
  const QString path = QFileDialog::getOpenFileName(window_, title, last_folder(), filters);
  if (!path.isEmpty()) remember_folder(path);
  return path;
}

QString Files::choose_folder(const QString& title) {
  return QFileDialog::getExistingDirectory(window_, title, last_folder());
}

QString Files::last_folder() const {
  return Preferences(kinds_.program).value(folder_key, QDir::homePath()).toString();
}

void Files::remember_folder(const QString& path) {
  Preferences(kinds_.program).set_value(folder_key, QFileInfo(path).absolutePath());
}

}  // namespace mesecina
