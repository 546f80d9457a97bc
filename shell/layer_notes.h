// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLabel>
#include <QString>
#include <vector>

#include "core/style.h"

namespace mesecina {

/// A few words at the bottom left of a canvas about the visible layers that could not be computed, so that an empty
/// canvas does not leave one guessing. Not part of any picture. Hidden while there is nothing to say.
class Layer_notes : public QLabel {
  Q_OBJECT
 public:
  struct Note {
    QString layer;   ///< id
    QString label;   ///< "Medial axis"
    QString reason;  ///< "needs at least 3 samples"
    bool operator==(const Note&) const = default;
  };
  /// Longer lists are cut, the last line then tells how many more there are.
  static constexpr std::size_t most_lines = 3;

  explicit Layer_notes(QWidget* canvas);

  /// Readable on `background`.
  void set_notes(std::vector<Note> notes, Color background);
  /// The lines as they are shown, without marks; each may take several rows.
  QStringList lines() const;

 Q_SIGNALS:
  /// The user clicked on what is said of this layer.
  void chosen(const QString& layer);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void arrange();

  std::vector<Note> notes_;
  Color background_;
};

/// False when a layer shows nothing only because there is no input of the kind it is about: nothing is wrong then.
bool is_worth_a_note(const QString& reason);

}  // namespace mesecina
