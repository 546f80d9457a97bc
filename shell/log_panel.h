// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDateTime>
#include <QWidget>
#include <vector>

#include "core/place.h"
#include "shell/message_bar.h"

class QComboBox;
class QTreeWidget;

namespace mesecina {

/// Everything the program has said, with the layer or the file that it is about.
class Log_panel : public QWidget {
  Q_OBJECT
 public:
  struct Entry {
    Message_bar::Kind kind = Message_bar::Kind::note;
    QString source;  ///< "Files", "Medial axis"
    QString text;
    QString layer;                   ///< its id; empty for none
    std::vector<Place> places = {};  ///< that it is about
    QDateTime time = QDateTime::currentDateTime();
  };
  static constexpr std::size_t most_entries = 2000;

  explicit Log_panel(QWidget* parent = nullptr);

  void add(const Entry& entry);
  const std::vector<Entry>& entries() const { return entries_; }
  /// What is shown, one line each: time, level, source, text, with tabs between.
  QString text() const;

 Q_SIGNALS:
  /// The user wants to see where that is.
  void places_chosen(const std::vector<mesecina::Place>& places);
  /// The user wants to see the layer that an entry is about.
  void layer_chosen(const QString& layer);
  /// The user wants to see the folder of a file.
  void file_chosen(const QString& path);
  void save_requested();

 private:
  bool is_shown(const Entry& entry) const;
  void show_entry(std::size_t number);
  void fill();
  void clear();
  void jump(int entry);

  std::vector<Entry> entries_;
  QComboBox* level_;
  QTreeWidget* list_;
};

/// The first word of a text that is the path of a file or folder that exists; empty for none.
QString path_in(const QString& text);

}  // namespace mesecina
