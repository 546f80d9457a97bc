// SPDX-License-Identifier: GPL-3.0-or-later
#include "layers/layer_model.h"

#include <QMimeData>
#include <algorithm>
#include <utility>

#include "core/help_text.h"
#include "layers/missing_input.h"
#include "layers/panel_paint.h"

namespace mesecina {

namespace {

constexpr quintptr no_stage = 0;  // internal id of a stage's own index; those of its layers hold its number
QString mime_type() { return QStringLiteral("application/x-mesecina-layers"); }

QStringList dragged_layers(const QMimeData* data) {
  return QString::fromUtf8(data->data(mime_type())).split(QLatin1Char('\n'), Qt::SkipEmptyParts);
}

bool has_same_rows(const std::vector<Shown_stage>& a, const Layer_list& a_layers, const std::vector<Shown_stage>& b,
                   const Layer_list& b_layers) {
  const auto has_same_layers = [&](const Shown_stage& first, const Shown_stage& second) {
    return first.name == second.name &&
           std::equal(first.entries.begin(), first.entries.end(), second.entries.begin(), second.entries.end(),
                      [&](std::size_t i, std::size_t j) { return a_layers[i].id == b_layers[j].id; });
  };
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), has_same_layers);
}

bool is_visible(const Layer_list& layers, std::size_t index) { return layers[index].style.visible; }

}  // namespace

Layer_model::Layer_model(std::shared_ptr<const Registry> registry, QObject* parent)
    : QAbstractItemModel(parent), registry_(std::move(registry)) {}

/// Numbers a stage for good, wherever its row is: one more than the registry's first layer of that stage.
quintptr Layer_model::stage_number(const std::string& stage) const {
  const auto& layers = registry_->layers();
  const auto it = std::find_if(layers.begin(), layers.end(), [&](const Layer_spec& s) { return s.stage == stage; });
  return static_cast<quintptr>(it - layers.begin()) + 1;
}

void Layer_model::set_layers(const Layer_list& layers) {
  std::vector<Shown_stage> stages = shown_stages(*registry_, layers);
  if (!has_same_rows(stages_, layers_, stages, layers)) {
    layout(std::move(stages), layers);
    return;
  }
  const Layer_list old = std::exchange(layers_, layers);
  const std::vector<Shown_stage> old_stages = std::exchange(stages_, std::move(stages));
  for (std::size_t s = 0; s < stages_.size(); ++s) {
    const QModelIndex stage = index(static_cast<int>(s), 0);
    bool is_stage_changed = old_stages[s].is_interleaved != stages_[s].is_interleaved;
    for (std::size_t row = 0; row < stages_[s].entries.size(); ++row) {
      if (old[old_stages[s].entries[row]] == layers_[stages_[s].entries[row]]) continue;
      is_stage_changed = true;
      const QModelIndex changed = index(static_cast<int>(row), 0, stage);
      Q_EMIT dataChanged(changed, changed);
    }
    if (is_stage_changed) Q_EMIT dataChanged(stage, stage);
  }
}

/// Other rows than before: keeps selection and expansion where the same layers and stages are still there.
void Layer_model::layout(std::vector<Shown_stage> stages, const Layer_list& layers) {
  Q_EMIT layoutAboutToBeChanged();
  const QModelIndexList before = persistentIndexList();
  QStringList names;
  for (const QModelIndex& index : before) names << data(index, id_role).toString();
  layers_ = layers;
  stages_ = std::move(stages);
  QModelIndexList after;
  for (qsizetype i = 0; i < before.size(); ++i) {
    if (before[i].internalId() != no_stage) {
      after << find(names[i]);
      continue;
    }
    const auto it = std::find_if(stages_.begin(), stages_.end(),
                                 [&](const Shown_stage& stage) { return stage.name == names[i].toStdString(); });
    after << (it == stages_.end() ? QModelIndex() : index(static_cast<int>(it - stages_.begin()), 0));
  }
  changePersistentIndexList(before, after);
  Q_EMIT layoutChanged();
}

void Layer_model::set_status(const std::string& layer, const Layer_status& status) {
  statuses_.insert_or_assign(layer, status);
  const QModelIndex changed = find(QString::fromStdString(layer));
  if (changed.isValid()) Q_EMIT dataChanged(changed, changed);
}

QModelIndex Layer_model::find(const QString& layer) const {
  const std::string id = layer.toStdString();
  for (std::size_t s = 0; s < stages_.size(); ++s) {
    const auto& rows = stages_[s].entries;
    const auto it = std::find_if(rows.begin(), rows.end(), [&](std::size_t i) { return layers_[i].id == id; });
    if (it != rows.end()) {
      return index(static_cast<int>(it - rows.begin()), 0, index(static_cast<int>(s), 0));
    }
  }
  return {};
}

QString Layer_model::label(const std::string& layer) const {
  const Layer_spec* spec = registry_->find_layer(layer);
  return QString::fromStdString(spec ? spec->label : layer);
}

bool Layer_model::is_any_computing() const {
  return std::any_of(statuses_.begin(), statuses_.end(), [](const auto& named_status) {
    return named_status.second.state == Layer_status::State::computing;
  });
}

QModelIndex Layer_model::index(int row, int column, const QModelIndex& parent) const {
  if (column != 0 || row < 0 || row >= rowCount(parent)) return {};
  if (!parent.isValid()) return createIndex(row, column, no_stage);
  return createIndex(row, column, stage_number(stages_[static_cast<std::size_t>(parent.row())].name));
}

QModelIndex Layer_model::parent(const QModelIndex& child) const {
  if (!child.isValid() || child.internalId() == no_stage) return {};
  for (std::size_t s = 0; s < stages_.size(); ++s) {
    if (stage_number(stages_[s].name) == child.internalId()) return createIndex(static_cast<int>(s), 0, no_stage);
  }
  return {};
}

int Layer_model::rowCount(const QModelIndex& parent) const {
  if (!parent.isValid()) return static_cast<int>(stages_.size());
  if (parent.internalId() != no_stage || parent.row() >= static_cast<int>(stages_.size())) return 0;
  return static_cast<int>(stages_[static_cast<std::size_t>(parent.row())].entries.size());
}

int Layer_model::columnCount(const QModelIndex&) const { return 1; }

const Layer_entry& Layer_model::entry(const QModelIndex& index) const {
  const Shown_stage& stage = stages_[static_cast<std::size_t>(index.parent().row())];
  return layers_[stage.entries[static_cast<std::size_t>(index.row())]];
}

QVariant Layer_model::data(const QModelIndex& index, int role) const {
  if (!checkIndex(index, CheckIndexOption::IndexIsValid)) return {};
  if (role == is_stage_role) return index.internalId() == no_stage;
  if (index.internalId() == no_stage) return stage_data(stages_[static_cast<std::size_t>(index.row())], role);
  return layer_data(entry(index), role);
}

QVariant Layer_model::stage_data(const Shown_stage& stage, int role) const {
  const auto all = static_cast<std::ptrdiff_t>(stage.entries.size());
  const auto visible =
      std::count_if(stage.entries.begin(), stage.entries.end(), [&](std::size_t i) { return is_visible(layers_, i); });
  const QString name = QString::fromStdString(stage.name);
  switch (role) {
    case Qt::DisplayRole:
    case id_role:
      return name;
    case Qt::CheckStateRole:
      return visible == 0 ? Qt::Unchecked : visible == all ? Qt::Checked : Qt::PartiallyChecked;
    case count_role:
      return tr("%1 of %2", "visible of all layers").arg(visible).arg(all);
    case is_interleaved_role:
      return stage.is_interleaved;
    case Qt::AccessibleTextRole:
      return tr("Stage %1, %2 of %3 layers visible").arg(name).arg(visible).arg(all);
    case Qt::WhatsThisRole:
    case Qt::ToolTipRole: {
      const QString text = tr("%1: %2 of %3 layers visible").arg(name).arg(visible).arg(all);
      if (!stage.is_interleaved) return text;
      return text + QLatin1Char('\n') +
             tr("Layers of other stages are drawn between these. “Draw together” in the menu changes that.");
    }
    default:
      return {};
  }
}

QVariant Layer_model::layer_data(const Layer_entry& entry, int role) const {
  const Layer_spec& spec = *registry_->find_layer(entry.id);
  static const Layer_status unknown;
  const auto it = statuses_.find(entry.id);
  const Layer_status& status = it == statuses_.end() ? unknown : it->second;
  const bool is_failed = status.state == Layer_status::State::failed;
  switch (role) {
    case Qt::DisplayRole:
      return QString::fromStdString(spec.label);
    case Qt::WhatsThisRole:
    case Qt::ToolTipRole:
      return tool_tip(spec);
    case Qt::CheckStateRole:
      return entry.style.visible ? Qt::Checked : Qt::Unchecked;
    case Qt::AccessibleTextRole:
      return entry.style.visible ? tr("%1, visible").arg(QString::fromStdString(spec.label))
                                 : tr("%1, hidden").arg(QString::fromStdString(spec.label));
    case Qt::AccessibleDescriptionRole:
      return status.reason.isEmpty() ? help_of(spec) : status.reason;
    case id_role:
      return QString::fromStdString(entry.id);
    case style_role:
      return QVariant::fromValue(entry.style);
    case count_role: {
      const bool is_known = status.state == Layer_status::State::current || status.count > 0;
      return is_known && status.state != Layer_status::State::failed ? grouped_count(status.count) : QString();
    }
    case state_role:
      return static_cast<int>(is_failed && !entry.style.visible ? Layer_status::State::not_computed : status.state);
    case reason_role:
      return is_failed && entry.style.visible ? status.reason : QString();
    case is_input_missing_role:
      return is_failed && is_input_missing(status.reason);
    case warnings_role:
      return entry.style.visible ? status.warnings : QStringList();
    case search_role:
      return QStringList{QString::fromStdString(spec.label), QString::fromStdString(spec.id), help_of(spec)}.join(
          QLatin1Char('\n'));
    default:
      return {};
  }
}

QString Layer_model::help_of(const Layer_spec& spec) const {
  return QString::fromStdString(with_labels(spec.help, *registry_));
}

QString Layer_model::tool_tip(const Layer_spec& spec) const {
  QString text = QStringLiteral("<p><b>%1</b></p>").arg(QString::fromStdString(spec.label).toHtmlEscaped());
  if (!spec.help.empty()) text += QStringLiteral("<p>%1</p>").arg(help_of(spec).toHtmlEscaped());
  if (const auto it = statuses_.find(spec.id); it != statuses_.end()) {
    const Layer_status& status = it->second;
    if (status.state == Layer_status::State::failed) {
      text += QStringLiteral("<p>%1</p>").arg(tr("Not available: %1").arg(status.reason.toHtmlEscaped()));
    } else if (status.state == Layer_status::State::stale) {
      text += QStringLiteral("<p>%1</p>").arg(tr("Shows an earlier result."));
    } else if (status.state == Layer_status::State::current && status.seconds > 0) {
      text += QStringLiteral("<p>%1</p>").arg(tr("Computed in %1 s.").arg(short_number(status.seconds, 3)));
    }
    for (const QString& warning : status.warnings) text += QStringLiteral("<p>%1</p>").arg(warning.toHtmlEscaped());
  }
  return text + QStringLiteral("<p><code>%1</code></p>").arg(QString::fromStdString(spec.id).toHtmlEscaped());
}

Qt::ItemFlags Layer_model::flags(const QModelIndex& index) const {
  if (!index.isValid()) return Qt::NoItemFlags;
  if (index.internalId() == no_stage) return Qt::ItemIsEnabled | Qt::ItemIsUserCheckable | Qt::ItemIsDropEnabled;
  return Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsUserCheckable | Qt::ItemIsDragEnabled |
         Qt::ItemNeverHasChildren;
}

QStringList Layer_model::mimeTypes() const { return {mime_type()}; }

QMimeData* Layer_model::mimeData(const QModelIndexList& indexes) const {
  QStringList ids;
  for (const QModelIndex& index : indexes) ids << data(index, id_role).toString();
  auto* result = new QMimeData;
  result->setData(mime_type(), ids.join(QLatin1Char('\n')).toUtf8());
  return result;
}

bool Layer_model::canDropMimeData(const QMimeData* data, Qt::DropAction action, int, int,
                                  const QModelIndex& parent) const {
  if (action != Qt::MoveAction || !data->hasFormat(mime_type()) || !parent.isValid() ||
      parent.internalId() != no_stage) {
    return false;
  }
  const QStringList ids = dragged_layers(data);
  return !ids.isEmpty() &&
         std::all_of(ids.begin(), ids.end(), [&](const QString& id) { return find(id).parent() == parent; });
}

bool Layer_model::dropMimeData(const QMimeData* data, Qt::DropAction action, int row, int column,
                               const QModelIndex& parent) {
  if (!canDropMimeData(data, action, row, column, parent)) return false;
  std::vector<std::string> moved;
  for (const QString& id : dragged_layers(data)) moved.push_back(id.toStdString());
  const std::string& stage = stages_[static_cast<std::size_t>(parent.row())].name;
  const Layer_list reordered =
      move_within_stage(*registry_, layers_, stage, moved, static_cast<std::size_t>(std::max(row, 0)));
  if (reordered != layers_) Q_EMIT order_requested(reordered);
  return true;
}

}  // namespace mesecina
