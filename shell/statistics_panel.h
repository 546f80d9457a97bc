// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "core/run_record.h"
#include "core/style.h"
#include "shell/background_jobs.h"

class QComboBox;
class QTreeWidget;

namespace mesecina {

/// What computations have cost and found out: one run as a table, or two of them side by side, and all in files.
class Statistics_panel : public QWidget {
  Q_OBJECT
 public:
  static constexpr std::size_t most_runs = 100;

  explicit Statistics_panel(QWidget* parent = nullptr);

  /// The newest run. `layers`: the pictures of its layers, whose topology is found out in the background once somebody
  /// looks. A run that follows one of the same step within half a second takes its place, so that a drag is one run.
  void add(Run_record record, std::vector<Scene_layer> layers);
  const std::vector<Run_record>& runs() const { return runs_; }
  /// CSV or JSON, by the extension. Throws File_error.
  void write(const QString& path) const;

 Q_SIGNALS:
  /// The user wants a file of all runs.
  void export_requested();

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  void fill_choices();
  void fill_table();
  void find_topology();
  void take_topology(int run, const std::map<std::string, Topology>& found);

  std::vector<Run_record> runs_;
  std::vector<Scene_layer> layers_;  ///< of the newest run, until their topology is known
  int next_number_ = 1;
  QComboBox* shown_;
  QComboBox* compared_;
  QTreeWidget* table_;
  Background_jobs jobs_;
};

}  // namespace mesecina
