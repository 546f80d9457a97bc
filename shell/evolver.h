// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>
#include <cstdint>
#include <memory>
#include <string>

#include "core/worker.h"
#include "shell/document.h"

namespace mesecina {

/// Makes steps of evolutions for a document, on a thread of its own. It has structures of its own too: what the user
/// looks at meanwhile is another place of the track, and neither undoes the work of the other.
class Evolver : public QObject {
  Q_OBJECT
 public:
  Evolver(std::shared_ptr<const Registry> registry, Document& document, QObject* parent = nullptr);
  /// Cancels and returns within about 100 ms.
  ~Evolver() override;

  /// Begins to make steps after this place of the track; what was under way is stopped, places after it go with the
  /// first step. `follows`: the document goes along while it shows the last place. Unknown evolutions do nothing.
  void make_steps(const std::string& evolution, std::uint64_t count, std::size_t position, bool follows);
  bool is_busy() const { return is_busy_; }
  /// While it is busy: of the last place that there is of the track that is being made.
  std::size_t position() const { return position_; }

 public Q_SLOTS:
  /// Steps that are there stay.
  void cancel();

 Q_SIGNALS:
  void busy_changed(bool is_busy);
  /// `fraction` in [0,1] of all steps that are wanted.
  void progressed(const QString& text, double fraction);
  /// There are fewer steps than were wanted: why.
  void ended(const QString& evolution, const QString& reason);

 private:
  void react(const Document_change& change);
  void take(const Worker::Step_result& result);
  void finish(std::uint64_t ticket);
  void set_busy(bool is_busy);
  QString progress_text() const;

  std::shared_ptr<const Registry> registry_;
  Document& document_;
  const Evolution_spec* evolution_ = nullptr;
  std::uint64_t ticket_ = 0;
  std::uint64_t made_ = 0;
  std::uint64_t wanted_ = 0;
  std::size_t position_ = 0;
  Evolution_state state_;  ///< there
  Track_pointer track_;    ///< the document's after the last step
  bool follows_ = false;
  bool is_adding_ = false;
  bool is_busy_ = false;
  std::unique_ptr<Worker> worker_;
};

}  // namespace mesecina
