// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>
#include <QWidget>
#include <memory>
#include <vector>

#include "core/place.h"
#include "layers/layer_list.h"

namespace mesecina {

struct Layer_status {
  enum class State { not_computed, current, stale, computing, failed };
  State state = State::not_computed;
  QString reason;  ///< when failed
  QStringList warnings;
  std::vector<std::vector<Place>> places = {};  ///< of each warning, where it is
  std::size_t count = 0;                        ///< elements
  double seconds = 0;
};

/// The list of layers with their looks, and below it the look of the selected ones with a histogram.
///
/// Rows are grouped by stage, the topmost layer first within the whole; a row has eye, swatch, name, count and state.
/// The panel owns no truth: it shows what it was given and says what the user wants changed.
class Layer_panel : public QWidget {
  Q_OBJECT
 public:
  explicit Layer_panel(std::shared_ptr<const Registry> registry, QWidget* parent = nullptr);
  ~Layer_panel() override;

  void set_layers(const Layer_list& layers);
  const Layer_list& layers() const;
  void set_status(const std::string& layer, const Layer_status& status);
  /// For count, histogram and range; null when there is nothing.
  void set_primitives(const std::string& layer, std::shared_ptr<const Primitive_set> primitives);
  void set_settings(const Settings& settings);  ///< for the cuts
  QStringList selected() const;
  void select(const QStringList& layers);
  /// The filter box gets the focus (Ctrl+F).
  void focus_filter();

 public Q_SLOTS:
  void toggle_visibility();  ///< of the selected layers (H)
  void solo();               ///< only the selected ones are visible; again: what was visible before (S)
  void show_all();           ///< (Alt+H)

 Q_SIGNALS:
  /// `what` in the user's words ("Colour of Voronoi diagram"); changes with the same non-empty `merge` key that follow
  /// each other are one undo step.
  void layers_edited(const mesecina::Layer_list& layers, const QString& what, const QString& merge);
  /// A threshold of the histogram that belongs to a setting was dragged.
  void setting_edited(const QString& setting, double value, const QString& merge);
  void selection_changed(const QStringList& layers);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace mesecina
