// SPDX-License-Identifier: GPL-3.0-or-later
#include "layers/layer_panel.h"

#include <QClipboard>
#include <QFrame>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QItemSelectionModel>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QScrollArea>
#include <QSplitter>
#include <QToolButton>
#include <QVBoxLayout>
#include <QWhatsThis>
#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "layers/layer_model.h"
#include "layers/layer_tree.h"
#include "layers/layer_visibility.h"
#include "layers/panel_paint.h"
#include "layers/style_editor.h"

namespace mesecina {

namespace {

double to_number(const Setting_value& value) {
  if (const auto* whole = std::get_if<std::int64_t>(&value)) return static_cast<double>(*whole);
  const auto* real = std::get_if<double>(&value);
  return real ? *real : 0;
}

}  // namespace

struct Layer_panel::State {
  std::shared_ptr<const Registry> registry;
  std::map<std::string, Layer_status> statuses;
  std::map<std::string, std::shared_ptr<const Primitive_set>> primitives;
  Settings settings;
  Visibility_memory visibility;
  std::optional<Style> copied_style;
  int sweep = 0;  ///< numbers the clicks on eyes: what one press sweeps over is one change

  Layer_panel* panel = nullptr;
  Layer_model* model = nullptr;
  Layer_tree* tree = nullptr;
  QLineEdit* filter = nullptr;
  QToolButton* visible_only = nullptr;
  QToolButton* style_header = nullptr;
  QToolButton* style_reset = nullptr;
  QScrollArea* style_area = nullptr;
  Style_editor* editor = nullptr;

  void build_filter_row(QVBoxLayout* layout);
  void build_style_section(QVBoxLayout* layout);
  void connect_tree();
  void connect_editor();

  Layer_ids selected_ids() const;
  Layer_ids stage_ids(const QModelIndex& stage) const;
  /// The selected layers if this one is among them, else it alone.
  Layer_ids addressed_by(const QModelIndex& index) const;
  /// "Voronoi diagram", "3 layers"
  QString name_of(const Layer_ids& ids) const;
  void change_styles(const Layer_ids& ids, const Style_editor::Change& change, const QString& what,
                     const QString& merge = {});
  void set_visible(const Layer_ids& ids, bool is_visible, const QString& merge = {});
  void apply(const Layer_list& layers, const QString& what, const QString& merge = {});
  void solo(const Layer_ids& ids);
  void click_eye(const QModelIndex& index, bool is_solo);
  void show_style(bool is_shown);
  void reset_style(const Layer_ids& ids);
  void paste_style(const Layer_ids& ids);
  void refresh_status(const std::string& layer);
  void refresh_editor();
  Style_editor::Subject subject(const Layer_entry& entry) const;
  void open_menu(const QPoint& position);
  void fill_stage_menu(QMenu* menu, const QModelIndex& stage);
  void fill_layer_menu(QMenu* menu, const QModelIndex& index);
};

Layer_panel::Layer_panel(std::shared_ptr<const Registry> registry, QWidget* parent)
    : QWidget(parent), state_(std::make_unique<State>()) {
  State& s = *state_;
  s.panel = this;
  s.registry = std::move(registry);
  s.model = new Layer_model(s.registry, this);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  s.build_filter_row(layout);
  s.tree = new Layer_tree(s.model, this);
  s.build_style_section(layout);
  s.connect_tree();
  s.connect_editor();
  s.refresh_editor();
}

Layer_panel::~Layer_panel() {
  // Widgets that die with the base class must not call back into the state.
  state_->tree->disconnect(this);
  state_->tree->selectionModel()->disconnect(this);
  state_->editor->disconnect(this);
}

void Layer_panel::State::build_filter_row(QVBoxLayout* layout) {
  const int em = panel->fontMetrics().height();
  auto* row = new QHBoxLayout;
  row->setContentsMargins(em / 3, em / 3, em / 3, em / 3);
  row->setSpacing(em / 4);
  filter = new QLineEdit(panel);
  filter->setPlaceholderText(tr("Filter layers"));
  filter->setAccessibleName(tr("Filter layers"));
  filter->setToolTip(tr("Words of the name, id or description of a layer"));
  filter->setClearButtonEnabled(true);
  visible_only = new QToolButton(panel);
  visible_only->setCheckable(true);
  visible_only->setAutoRaise(true);
  visible_only->setIcon(painted_icon(
      [](QPainter& painter, const QRectF& square, const QColor& color) { paint_eye(painter, square, color, true); }));
  visible_only->setToolTip(tr("List visible layers only"));
  visible_only->setAccessibleName(tr("Visible layers only"));
  row->addWidget(filter, 1);
  row->addWidget(visible_only);
  layout->addLayout(row);
  const auto update_filter = [this] { tree->set_filter(filter->text(), visible_only->isChecked()); };
  connect(filter, &QLineEdit::textChanged, panel, update_filter);
  connect(visible_only, &QToolButton::toggled, panel, update_filter);
}

void Layer_panel::State::build_style_section(QVBoxLayout* layout) {
  const int em = panel->fontMetrics().height();
  auto* splitter = new QSplitter(Qt::Vertical, panel);
  splitter->setChildrenCollapsible(false);
  layout->addWidget(splitter, 1);
  splitter->addWidget(tree);
  tree->setMinimumHeight(em * 6);

  auto* section = new QWidget(splitter);
  auto* column = new QVBoxLayout(section);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  auto* line = new QFrame(section);
  line->setFrameShape(QFrame::HLine);
  line->setFrameShadow(QFrame::Plain);
  line->setForegroundRole(QPalette::Mid);
  column->addWidget(line);
  auto* header = new QHBoxLayout;
  header->setContentsMargins(em / 4, em / 5, em / 4, 0);
  style_header = new QToolButton(section);
  style_header->setAutoRaise(true);
  QFont heading = style_header->font();
  heading.setBold(true);
  style_header->setFont(heading);
  style_header->setToolTip(tr("Show or hide the looks of the selected layers"));
  style_header->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  style_header->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
  style_header->setAccessibleName(tr("Style of the selected layers"));
  style_reset = new QToolButton(section);
  style_reset->setAutoRaise(true);
  style_reset->setText(tr("Reset"));
  style_reset->setToolTip(tr("Back to the look these layers came with"));
  header->addWidget(style_header, 1);
  header->addWidget(style_reset);
  column->addLayout(header);

  style_area = new QScrollArea(section);
  style_area->setWidgetResizable(true);
  style_area->setFrameShape(QFrame::NoFrame);
  style_area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  editor = new Style_editor(style_area);
  style_area->setWidget(editor);
  column->addWidget(style_area, 1);
  splitter->addWidget(section);
  show_style(true);
  splitter->setStretchFactor(0, 1);
  splitter->setStretchFactor(1, 0);
  splitter->setSizes({em * 18, em * 25});
}

void Layer_panel::State::connect_tree() {
  connect(tree, &Layer_tree::eye_clicked, panel,
          [this](const QModelIndex& index, bool is_solo) { click_eye(index, is_solo); });
  connect(tree, &Layer_tree::eye_swept, panel, [this](const QModelIndex& index, bool is_visible) {
    set_visible({index.data(Layer_model::id_role).toString().toStdString()}, is_visible,
                QStringLiteral("eyes/%1").arg(sweep));
  });
  connect(tree, &Layer_tree::swatch_clicked, panel, [this](const QModelIndex& index) {
    if (!tree->selectionModel()->isSelected(index)) {
      tree->selectionModel()->setCurrentIndex(index, QItemSelectionModel::ClearAndSelect);
    }
    show_style(true);
    editor->choose_color();
  });
  connect(tree, &Layer_tree::toggle_requested, panel, &Layer_panel::toggle_visibility);
  connect(tree, &Layer_tree::style_requested, panel, [this] {
    show_style(true);
    editor->focus_first();
  });
  connect(tree, &QWidget::customContextMenuRequested, panel, [this](const QPoint& position) { open_menu(position); });
  connect(tree->selectionModel(), &QItemSelectionModel::selectionChanged, panel, [this] {
    refresh_editor();
    Q_EMIT panel->selection_changed(panel->selected());
  });
  connect(tree->selectionModel(), &QItemSelectionModel::currentChanged, panel, [this] { refresh_editor(); });
  connect(model, &Layer_model::order_requested, panel,
          [this](const Layer_list& layers) { apply(layers, tr("Order of layers")); });
}

void Layer_panel::State::connect_editor() {
  connect(editor, &Style_editor::edited, panel,
          [this](const Style_editor::Change& change, const QString& what, const QString& merge) {
            const Layer_ids ids = selected_ids();
            change_styles(ids, change, tr("%1 of %2").arg(what, name_of(ids)), merge);
          });
  connect(editor, &Style_editor::cut_edited, panel,
          [this](const QString& setting, const std::optional<double>& value, const QString& merge) {
            const Setting_spec* spec = registry->find_setting(setting.toStdString());
            if (!spec) return;
            double chosen = value.value_or(to_number(spec->default_value));
            if (std::holds_alternative<std::int64_t>(spec->default_value)) chosen = std::round(chosen);
            Q_EMIT panel->setting_edited(setting, chosen, merge);
          });
  connect(style_header, &QToolButton::clicked, panel, [this] { show_style(style_area->isHidden()); });
  connect(style_reset, &QToolButton::clicked, panel, [this] { reset_style(selected_ids()); });
}

Layer_ids Layer_panel::State::selected_ids() const {
  Layer_ids ids;
  for (const QModelIndex& index : tree->selected_layers()) {
    ids.push_back(index.data(Layer_model::id_role).toString().toStdString());
  }
  return ids;
}

Layer_ids Layer_panel::State::stage_ids(const QModelIndex& stage) const {
  Layer_ids ids;
  for (int row = 0; row < model->rowCount(stage); ++row) {
    ids.push_back(model->index(row, 0, stage).data(Layer_model::id_role).toString().toStdString());
  }
  return ids;
}

Layer_ids Layer_panel::State::addressed_by(const QModelIndex& index) const {
  if (tree->selectionModel()->isSelected(index)) return selected_ids();
  return {index.data(Layer_model::id_role).toString().toStdString()};
}

QString Layer_panel::State::name_of(const Layer_ids& ids) const {
  return ids.size() == 1 ? model->label(ids.front()) : tr("%n layers", nullptr, static_cast<int>(ids.size()));
}

void Layer_panel::State::apply(const Layer_list& layers, const QString& what, const QString& merge) {
  if (layers != model->layers()) Q_EMIT panel->layers_edited(layers, what, merge);
}

void Layer_panel::State::change_styles(const Layer_ids& ids, const Style_editor::Change& change, const QString& what,
                                       const QString& merge) {
  Layer_list layers = model->layers();
  for (const std::string& id : ids) {
    if (Layer_entry* entry = find_entry(layers, id)) change(entry->style);
  }
  apply(layers, what, merge);
}

void Layer_panel::State::set_visible(const Layer_ids& ids, bool is_visible, const QString& merge) {
  apply(with_visibility(model->layers(), ids, is_visible),
        (is_visible ? tr("Show %1") : tr("Hide %1")).arg(name_of(ids)), merge);
}

void Layer_panel::State::solo(const Layer_ids& ids) {
  if (!ids.empty()) apply(visibility.toggle_solo(model->layers(), ids), tr("Solo %1").arg(name_of(ids)));
}

void Layer_panel::State::click_eye(const QModelIndex& index, bool is_solo) {
  const bool is_visible = index.data(Qt::CheckStateRole).toInt() != Qt::Unchecked;
  if (index.data(Layer_model::is_stage_role).toBool()) {
    const Layer_ids ids = stage_ids(index);
    const QString name = index.data().toString();
    if (is_solo) {
      solo(ids);
    } else {
      apply(visibility.toggle_group(model->layers(), name.toStdString(), ids),
            (is_visible ? tr("Hide %1") : tr("Show %1")).arg(name));
    }
  } else if (is_solo) {
    solo(addressed_by(index));
  } else {
    set_visible(addressed_by(index), !is_visible, QStringLiteral("eyes/%1").arg(++sweep));
  }
}

void Layer_panel::State::reset_style(const Layer_ids& ids) {
  Layer_list layers = model->layers();
  for (const std::string& id : ids) {
    Layer_entry* entry = find_entry(layers, id);
    const Layer_spec* spec = registry->find_layer(id);
    if (!entry || !spec) continue;
    const bool is_visible = entry->style.visible;
    entry->style = spec->style;
    entry->style.visible = is_visible;
  }
  apply(layers, tr("Reset style of %1").arg(name_of(ids)));
}

void Layer_panel::State::paste_style(const Layer_ids& ids) {
  if (!copied_style) return;
  change_styles(
      ids,
      [this](Style& style) {
        const bool is_visible = style.visible;
        style = *copied_style;
        style.visible = is_visible;
      },
      tr("Paste style on %1").arg(name_of(ids)));
}

void Layer_panel::State::show_style(bool is_shown) {
  style_area->setVisible(is_shown);
  style_header->setArrowType(is_shown ? Qt::DownArrow : Qt::RightArrow);
  // A closed section gives its room to the list and leaves no gap of its own.
  style_area->parentWidget()->setMaximumHeight(is_shown ? QWIDGETSIZE_MAX
                                                        : style_area->parentWidget()->minimumSizeHint().height());
}

void Layer_panel::State::refresh_status(const std::string& layer) {
  const auto status = statuses.find(layer);
  Layer_status shown = status == statuses.end() ? Layer_status() : status->second;
  if (const auto it = primitives.find(layer); it != primitives.end() && it->second) {
    shown.count = it->second->element_count();
  }
  model->set_status(layer, shown);
}

Style_editor::Subject Layer_panel::State::subject(const Layer_entry& entry) const {
  Style_editor::Subject result;
  result.layer.id = entry.id;
  result.layer.label = model->label(entry.id).toStdString();
  result.layer.style = entry.style;
  if (const auto it = primitives.find(entry.id); it != primitives.end()) result.layer.primitives = it->second;
  const Layer_spec* spec = registry->find_layer(entry.id);
  if (!spec || spec->cut_setting.empty()) return result;
  result.layer.cut = registry->cut(*spec, settings);
  result.cut_setting = QString::fromStdString(spec->cut_setting);
  if (const Setting_spec* setting = registry->find_setting(spec->cut_setting)) {
    result.cut_label = QString::fromStdString(setting->label);
    result.cut_lowest = setting->minimum;
    result.cut_highest = setting->maximum;
    result.cut_default = to_number(setting->default_value);
  }
  return result;
}

void Layer_panel::State::refresh_editor() {
  const Layer_ids ids = selected_ids();
  std::vector<Style_editor::Subject> subjects;
  const std::string current = tree->currentIndex().data(Layer_model::id_role).toString().toStdString();
  for (const std::string& id : ids) {
    const Layer_entry* entry = find_entry(model->layers(), id);
    if (!entry) continue;
    const auto place = id == current ? subjects.begin() : subjects.end();
    subjects.insert(place, subject(*entry));
  }
  style_header->setText(ids.empty() ? tr("Style") : tr("Style of %1").arg(name_of(ids)));
  style_reset->setEnabled(!ids.empty());
  editor->set_subjects(std::move(subjects));
}

void Layer_panel::State::open_menu(const QPoint& position) {
  auto* menu = new QMenu(panel);
  menu->setAttribute(Qt::WA_DeleteOnClose);
  menu->setToolTipsVisible(true);
  const QModelIndex index = tree->indexAt(position);
  if (index.isValid() && index.data(Layer_model::is_stage_role).toBool()) {
    fill_stage_menu(menu, index);
  } else if (index.isValid()) {
    fill_layer_menu(menu, index);
  } else {
    menu->addAction(tr("Show all"), panel, &Layer_panel::show_all);
  }
  menu->popup(tree->viewport()->mapToGlobal(position));
}

void Layer_panel::State::fill_stage_menu(QMenu* menu, const QModelIndex& stage) {
  const std::vector<Shown_stage>& stages = model->stages();
  const auto row = static_cast<std::size_t>(stage.row());
  const std::string name = stages[row].name;
  const Layer_ids ids = stage_ids(stage);
  const QString title = stage.data().toString();
  menu->addAction(tr("Show the whole stage"), panel,
                  [=, this] { apply(with_visibility(model->layers(), ids, true), tr("Show %1").arg(title)); });
  menu->addAction(tr("Hide the whole stage"), panel,
                  [=, this] { apply(with_visibility(model->layers(), ids, false), tr("Hide %1").arg(title)); });
  menu->addAction(tr("Solo"), panel, [=, this] { solo(ids); });
  menu->addSeparator();
  const auto add_move = [&](const QString& text, const std::string& moved, const std::string& target) {
    menu->addAction(text, panel, [=, this] {
      apply(move_stage_above(*registry, model->layers(), moved, target), tr("Order of layers"));
    });
  };
  if (row > 0)
    add_move(tr("Draw above %1").arg(QString::fromStdString(stages[row - 1].name)), name, stages[row - 1].name);
  if (row + 1 < stages.size()) {
    add_move(tr("Draw below %1").arg(QString::fromStdString(stages[row + 1].name)), stages[row + 1].name, name);
  }
  if (stages[row].is_interleaved) {
    menu->addAction(tr("Draw together"), panel,
                    [=, this] { apply(gather_stage(*registry, model->layers(), name), tr("Order of layers")); });
  }
  menu->addSeparator();
  menu->addAction(tr("Expand all"), tree, &QTreeView::expandAll);
  menu->addAction(tr("Collapse all"), tree, &QTreeView::collapseAll);
}

void Layer_panel::State::fill_layer_menu(QMenu* menu, const QModelIndex& index) {
  const Layer_ids ids = addressed_by(index);
  const std::string id = index.data(Layer_model::id_role).toString().toStdString();
  menu->addAction(tr("Solo"), panel, [=, this] { solo(ids); });
  menu->addAction(tr("Show all"), panel, &Layer_panel::show_all);
  menu->addAction(tr("Hide"), panel, [=, this] { set_visible(ids, false); });
  menu->addAction(tr("Hide others"), panel, [=, this] {
    const Layer_list& layers = model->layers();
    Layer_ids kept;
    for (const std::string& visible : visible_layers(layers)) {
      if (std::find(ids.begin(), ids.end(), visible) != ids.end()) kept.push_back(visible);
    }
    apply(with_only_visible(layers, kept), tr("Hide all but %1").arg(name_of(ids)));
  });
  menu->addSeparator();
  menu->addAction(tr("Copy style"), panel, [=, this] {
    if (const Layer_entry* entry = find_entry(model->layers(), id)) copied_style = entry->style;
  });
  menu->addAction(tr("Paste style"), panel, [=, this] { paste_style(ids); })->setEnabled(copied_style.has_value());
  menu->addAction(tr("Reset style"), panel, [=, this] { reset_style(ids); });
  menu->addSeparator();
  menu->addAction(tr("Copy id"), panel, [=] {
    QStringList texts;
    for (const std::string& copied : ids) texts << QString::fromStdString(copied);
    QGuiApplication::clipboard()->setText(texts.join(QLatin1Char('\n')));
  });
  menu->addAction(tr("What is this?"), panel, [this, layer = QString::fromStdString(id)] {
    const QModelIndex shown = model->find(layer);
    if (!shown.isValid()) return;
    const QPoint corner = tree->visualRect(shown).bottomLeft();
    QWhatsThis::showText(tree->viewport()->mapToGlobal(corner), shown.data(Qt::ToolTipRole).toString(), tree);
  });
}

void Layer_panel::set_layers(const Layer_list& layers) {
  state_->model->set_layers(layers);
  state_->refresh_editor();
}

const Layer_list& Layer_panel::layers() const { return state_->model->layers(); }

void Layer_panel::set_status(const std::string& layer, const Layer_status& status) {
  state_->statuses.insert_or_assign(layer, status);
  state_->refresh_status(layer);
}

void Layer_panel::set_primitives(const std::string& layer, std::shared_ptr<const Primitive_set> primitives) {
  std::shared_ptr<const Primitive_set>& kept = state_->primitives[layer];
  if (kept == primitives) return;
  kept = std::move(primitives);
  state_->refresh_status(layer);
  if (selected().contains(QString::fromStdString(layer))) state_->refresh_editor();
}

void Layer_panel::set_settings(const Settings& settings) {
  if (settings == state_->settings) return;
  state_->settings = settings;
  state_->refresh_editor();
}

QStringList Layer_panel::selected() const {
  QStringList result;
  for (const std::string& id : state_->selected_ids()) result << QString::fromStdString(id);
  return result;
}

void Layer_panel::select(const QStringList& layers) {
  QItemSelection selection;
  for (const QString& layer : layers) {
    const QModelIndex index = state_->model->find(layer);
    if (index.isValid()) selection.select(index, index);
  }
  QItemSelectionModel& model = *state_->tree->selectionModel();
  model.select(selection, QItemSelectionModel::ClearAndSelect);
  if (selection.isEmpty()) return;
  const QModelIndex first = selection.indexes().front();
  model.setCurrentIndex(first, QItemSelectionModel::NoUpdate);
  state_->tree->scrollTo(first);
}

void Layer_panel::focus_filter() {
  state_->filter->setFocus(Qt::ShortcutFocusReason);
  state_->filter->selectAll();
}

void Layer_panel::toggle_visibility() {
  const Layer_ids ids = state_->selected_ids();
  if (ids.empty()) return;
  const bool is_any_hidden = std::any_of(
      ids.begin(), ids.end(), [&](const std::string& id) { return !find_entry(layers(), id)->style.visible; });
  state_->set_visible(ids, is_any_hidden);
}

void Layer_panel::solo() { state_->solo(state_->selected_ids()); }

void Layer_panel::show_all() {
  Layer_ids ids;
  for (const Layer_entry& entry : layers()) ids.push_back(entry.id);
  state_->apply(with_visibility(layers(), ids, true), tr("Show all layers"));
}

}  // namespace mesecina
