// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/window_bundles.h"

#include <QDockWidget>
#include <QFileDialog>
#include <QMenu>
#include <QSaveFile>
#include <algorithm>
#include <exception>
#include <utility>

#include "bundles/bundle_panel.h"
#include "core/batch/bundle_library.h"
#include "core/batch/bundle_option.h"
#include "shell/actions.h"
#include "shell/document.h"
#include "shell/files.h"
#include "shell/message_bar.h"

namespace mesecina {

namespace {

class Background_step : public QUndoCommand {
 public:
  Background_step(Canvas_background before, Canvas_background after, std::function<void(Canvas_background)> show)
      : before_(before), after_(after), show_(std::move(show)) {}
  void undo() override { show_(before_); }
  void redo() override { show_(after_); }

 private:
  Canvas_background before_;
  Canvas_background after_;
  std::function<void(Canvas_background)> show_;
};

QString name_of(const Bundle& bundle) { return QString::fromStdString(bundle.name); }

}  // namespace

Window_bundles::Window_bundles(std::shared_ptr<const Registry> registry, Document& document, Message_bar& messages,
                               const QString& program, QWidget* parent)
    : QObject(parent),
      registry_(std::move(registry)),
      document_(document),
      messages_(messages),
      store_(registry_, document.history(), QString::fromStdString(user_bundle_file(program.toStdString()).string())),
      panel_(new Bundle_panel(parent)) {
  const QString reason = store_.load();
  if (!reason.isEmpty()) messages_.add(Message_bar::Kind::warning, reason);
  connect(&store_, &Bundle_store::changed, this, &Window_bundles::show_list);
  connect(&store_, &Bundle_store::failed, this,
          [this](const QString& text) { messages_.add(Message_bar::Kind::error, text); });
  connect(&document_, &Document::changed, this, [this](const Document_change& change) {
    const bool is_elsewhere = change.inputs || change.track;
    if (change.settings || change.layers || !is_elsewhere) mark_shown();
    if (change.inputs) mark_what_is_missing();
  });
  connect(panel_, &Bundle_panel::chosen, this, &Window_bundles::apply);
  // The panel is in the midst of its own change when it tells of these.
  connect(panel_, &Bundle_panel::renamed, this, &Window_bundles::rename, Qt::QueuedConnection);
  connect(panel_, &Bundle_panel::remove_requested, this, &Window_bundles::remove);
  connect(
      panel_, &Bundle_panel::moved, this,
      [this](int from, int to) {
        change(from, tr("Move bundle"), [from, to](std::vector<Bundle>& bundles) {
          Bundle bundle = bundles[static_cast<std::size_t>(from)];
          bundles.erase(bundles.begin() + from);
          bundles.insert(bundles.begin() + std::clamp(to, 0, static_cast<int>(bundles.size())), std::move(bundle));
        });
      },
      Qt::QueuedConnection);
  show_list();
}

void Window_bundles::set_view_access(std::function<void(Bundle&)> read, std::function<void(const Bundle&)> show) {
  read_view_ = std::move(read);
  show_view_ = std::move(show);
}

void Window_bundles::set_background_access(std::function<Canvas_background()> read,
                                           std::function<void(Canvas_background)> show) {
  read_background_ = std::move(read);
  show_background_ = std::move(show);
}

void Window_bundles::make_key_actions(Actions& actions) {
  const QString group = tr("Bundles");
  for (int key = 1; key <= most_bundle_keys; ++key)
    digit_actions_.push_back(actions.add(group,
                                         {QStringLiteral("bundle-%1").arg(key),
                                          tr("Bundle &%1").arg(key),
                                          tr("Show layers, looks and settings of the bundle with the key %1").arg(key),
                                          {QKeySequence(static_cast<Qt::Key>(Qt::Key_0 + key))}},
                                         [this, key] { apply_key(key); }));
  give_menu_ = new QMenu(tr("&Key"), panel_);
  const auto add_choice = [&](const QString& id, const QString& text, const QString& tip, std::optional<int> key) {
    QAction* action =
        actions.add(group, {id, text, tip, {}, {}, true}, [this, key] { give_key_to(panel_->selected(), key); });
    give_menu_->addAction(action);
    give_actions_.push_back(action);
  };
  for (int key = 1; key <= most_bundle_keys; ++key)
    add_choice(QStringLiteral("bundle-key-%1").arg(key), tr("Key &%1 for the bundle").arg(key),
               tr("The selected bundle of the list is shown by the key %1, and the one that had it no longer").arg(key),
               key);
  add_choice(QStringLiteral("bundle-key-none"), tr("N&o key for the bundle"),
             tr("No key shows the selected bundle of the list"), 0);
  add_choice(QStringLiteral("bundle-key-usual"), tr("&Usual key for the bundle"),
             tr("The selected bundle has the key of its place in the list: the first nine have one"), std::nullopt);
  connect(give_menu_, &QMenu::aboutToShow, this, &Window_bundles::mark_given_key);
}

void Window_bundles::mark_given_key() {
  const int row = panel_->selected();
  const auto& bundles = store_.bundles();
  const bool is_one = row >= 0 && row < static_cast<int>(bundles.size());
  constexpr int usual = most_bundle_keys + 1;
  const int given = is_one ? bundles[static_cast<std::size_t>(row)].key.value_or(usual) : -1;
  for (std::size_t i = 0; i < give_actions_.size(); ++i) {
    // 1 to 9, none, and the usual one.
    const int key = i == most_bundle_keys ? 0 : i > most_bundle_keys ? usual : static_cast<int>(i) + 1;
    give_actions_[i]->setChecked(given == key);
  }
}

void Window_bundles::name_key_actions() {
  for (std::size_t i = 0; i < digit_actions_.size(); ++i) {
    const int key = static_cast<int>(i) + 1;
    const auto place = place_with_key(store_.bundles(), key);
    QString name = place ? name_of(store_.bundles()[*place]) : tr("no bundle");
    digit_actions_[i]->setText(tr("&%1: %2").arg(key).arg(name.replace(QLatin1Char('&'), QStringLiteral("&&"))));
    digit_actions_[i]->setEnabled(place.has_value());
  }
}

void Window_bundles::make_actions(Actions& actions, QDockWidget* dock, Files* files) {
  dock_ = dock;
  files_ = files;
  const QString group = tr("Bundles");
  const auto add = [&](const char* id, const QString& text, const QString& tip, const QList<QKeySequence>& shortcuts,
                       std::function<void()> run) {
    return actions.add(group, {QLatin1String(id), text, tip, shortcuts}, std::move(run));
  };
  make_key_actions(actions);
  QAction* save = add("save-bundle", tr("&Save as bundle"),
                      tr("Keep the visible layers, their order and looks, and the settings, under a name"),
                      {QKeySequence(Qt::CTRL | Qt::Key_B)}, [this] { save_as_new(false); });
  QAction* save_view = add("save-bundle-with-view", tr("Save as bundle with &view"),
                           tr("The same, the part that is seen, and the background"),
                           {QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_B)}, [this] { save_as_new(true); });
  QAction* import = add("import-bundles", tr("&Import bundles…"),
                        tr("Add the bundles of a file, also of the .bnd files of earlier programs"), {}, [this] {
                          const QString path = QFileDialog::getOpenFileName(panel_, tr("Import bundles"), {},
                                                                            tr("Bundles (*.json *.bnd)"));
                          if (!path.isEmpty()) import_file(path);
                        });
  QAction* write =
      add("export-bundles", tr("&Export bundles…"), tr("Write all bundles of the list to a file"), {}, [this] {
        const QString path = files_->choose_for_writing(tr("Export bundles"), tr("bundles"), tr("Bundles (*.json)"));
        if (!path.isEmpty()) export_file(path);
      });
  QAction* reset = add("reset-bundles", tr("&Reset shipped bundles"),
                       tr("Bundles that came with the program are as they were; yours stay"), {}, [this] {
                         std::vector<Bundle> bundles = shipped_bundles(*registry_);
                         for (const Bundle& bundle : store_.bundles()) {
                           if (!find_bundle(bundles, bundle_id(bundle.name))) bundles.push_back(bundle);
                         }
                         store_.edit(std::move(bundles), tr("Reset shipped bundles"));
                       });
  QAction* change_it =
      add("update-bundle", tr("&Update bundle"), tr("The selected bundle of the list becomes what is on screen"), {},
          [this] { update(panel_->selected()); });
  QAction* rename_it = actions.add(group,
                                   {QStringLiteral("rename-bundle"),
                                    tr("Re&name bundle"),
                                    tr("Type another name for the selected bundle"),
                                    {QKeySequence(Qt::Key_F2)},
                                    {},
                                    false,
                                    panel_},
                                   [this] { panel_->edit_name(panel_->selected()); });
  QAction* delete_it = add("delete-bundle", tr("&Delete bundle"), tr("Take the selected bundle from the list"), {},
                           [this] { remove(panel_->selected()); });
  panel_->set_menu_actions({save, save_view, import, write, reset},
                           {change_it, rename_it, give_menu_->menuAction(), delete_it});
  name_key_actions();
}

void Window_bundles::apply(int row) {
  if (row < 0 || row >= static_cast<int>(store_.bundles().size())) return;
  const Bundle bundle = store_.bundles()[static_cast<std::size_t>(row)];
  Document_state state = document_.state();
  Arrangement arrangement = apply_bundle(bundle, *registry_, {state.settings, state.layers});
  state.settings = std::move(arrangement.settings);
  state.layers = std::move(arrangement.layers);
  state.bundle = bundle.name;
  const QString text = tr("Bundle '%1'").arg(name_of(bundle));
  if (bundle.background && read_background_ && read_background_() != *bundle.background) {
    // One step with the layers, so that undo brings both back.
    document_.history().beginMacro(text);
    document_.edit(std::move(state), text);
    document_.history().push(new Background_step(read_background_(), *bundle.background, show_background_));
    document_.history().endMacro();
  } else {
    document_.edit(std::move(state), text);
  }
  if (show_view_ && (bundle.view || bundle.view_3)) show_view_(bundle);
  for (const std::string& note : bundle.unknown.notes)
    messages_.add(Message_bar::Kind::warning, tr("Bundle '%1': %2").arg(name_of(bundle), QString::fromStdString(note)));
  panel_->select(row);
  mark_shown();
}

void Window_bundles::apply_key(int key) {
  if (const auto place = place_with_key(store_.bundles(), key)) apply(static_cast<int>(*place));
}

void Window_bundles::give_key_to(int row, std::optional<int> key) {
  change(row, tr("Key of bundle"),
         [&](std::vector<Bundle>& bundles) { give_key(bundles, static_cast<std::size_t>(row), key); });
  mark_given_key();
}

Bundle Window_bundles::current(const QString& name) const {
  return bundle_of({document_.settings(), document_.layers()}, *registry_, name.toStdString());
}

void Window_bundles::save_as_new(bool with_view) {
  Bundle bundle = current(QString::fromStdString(free_name(store_.bundles(), tr("My bundle").toStdString())));
  if (with_view && read_view_) read_view_(bundle);
  if (with_view && read_background_) bundle.background = read_background_();
  std::vector<Bundle> bundles = store_.bundles();
  const std::string name = bundle.name;
  bundles.push_back(std::move(bundle));
  store_.edit(std::move(bundles), tr("Save bundle"));
  document_.name_bundle(name);
  if (dock_) {
    dock_->show();
    dock_->raise();
  }
  panel_->edit_name(static_cast<int>(store_.bundles().size()) - 1);
}

void Window_bundles::change(int row, const QString& text, const std::function<void(std::vector<Bundle>&)>& change) {
  std::vector<Bundle> bundles = store_.bundles();
  if (row < 0 || row >= static_cast<int>(bundles.size())) return;
  change(bundles);
  store_.edit(std::move(bundles), text);
}

void Window_bundles::update(int row) {
  change(row, tr("Update bundle"), [&](std::vector<Bundle>& bundles) {
    Bundle& old = bundles[static_cast<std::size_t>(row)];
    Bundle bundle = current(name_of(old));
    bundle.help = old.help;
    bundle.unknown = old.unknown;
    bundle.key = old.key;
    bundle.needs = old.needs;
    if ((old.view || old.view_3) && read_view_) read_view_(bundle);
    if (old.background && read_background_) bundle.background = read_background_();
    old = std::move(bundle);
  });
}

void Window_bundles::rename(int row, const QString& name) {
  const std::string wanted = name.trimmed().toStdString();
  change(row, tr("Rename bundle"), [&](std::vector<Bundle>& bundles) {
    std::vector<Bundle> others = bundles;
    others.erase(others.begin() + row);
    if (wanted.empty()) return;
    std::string& own_name = bundles[static_cast<std::size_t>(row)].name;
    const bool is_in_force = own_name == document_.state().bundle;
    own_name = free_name(others, wanted);
    if (is_in_force) document_.name_bundle(own_name);
  });
  show_list();
}

void Window_bundles::remove(int row) {
  change(row, tr("Delete bundle"), [row](std::vector<Bundle>& bundles) { bundles.erase(bundles.begin() + row); });
}

void Window_bundles::import_file(const QString& path) {
  try {
    std::vector<Bundle> bundles = store_.bundles();
    const std::vector<Bundle> read = read_bundle_file(path.toStdString(), *registry_);
    for (Bundle bundle : read) {
      bundle.name = free_name(bundles, bundle.name);
      // Keys of the list stay those that one knows.
      if (bundle.key && std::ranges::count(bundles, bundle.key, &Bundle::key) > 0) bundle.key.reset();
      for (const std::string& note : bundle.unknown.notes)
        messages_.add(Message_bar::Kind::warning, QString::fromStdString(note));
      bundles.push_back(std::move(bundle));
    }
    store_.edit(std::move(bundles), tr("Import bundles"));
    messages_.add(Message_bar::Kind::note,
                  tr("%1: %n bundle(s) added to the list", "", static_cast<int>(read.size())).arg(path));
  } catch (const std::exception& error) {
    messages_.add(Message_bar::Kind::error, QString::fromStdString(error.what()));
  }
}

void Window_bundles::export_file(const QString& path) {
  QSaveFile file(path);
  const std::string text = bundles_to_text(store_.bundles(), *registry_);
  if (file.open(QIODevice::WriteOnly)) file.write(text.data(), static_cast<qint64>(text.size()));
  if (!file.commit())
    messages_.add(Message_bar::Kind::error, tr("%1: cannot be written (%2)").arg(path, file.errorString()));
}

void Window_bundles::show_list() {
  panel_->set_bundles(store_.bundles());
  name_key_actions();
  mark_shown();
  mark_what_is_missing();
}

void Window_bundles::mark_what_is_missing() {
  QStringList reasons;
  for (const Bundle& bundle : store_.bundles())
    reasons << QString::fromStdString(missing_input_text(bundle.needs, document_.inputs()));
  panel_->set_reasons(reasons);
}

std::optional<Session::Bundle_name> Window_bundles::in_force() const {
  const Arrangement shown{document_.settings(), document_.layers()};
  const std::string& last = document_.state().bundle;
  std::optional<Session::Bundle_name> name;
  if (!last.empty()) name = {last, true};
  for (const Bundle& bundle : store_.bundles()) {
    // Of several that are alike it is the one that was chosen.
    const bool is_candidate = bundle.name == last || !name || name->is_changed;
    if (is_candidate && apply_bundle(bundle, *registry_, shown) == shown) name = {bundle.name, false};
  }
  return name;
}

void Window_bundles::mark_shown() {
  const auto now = in_force();
  const auto& bundles = store_.bundles();
  const auto found = std::ranges::find(bundles, now ? now->name : std::string(), &Bundle::name);
  const bool is_listed = now && found != bundles.end();
  panel_->set_shown(is_listed ? static_cast<int>(found - bundles.begin()) : -1, is_listed && now->is_changed);
}

}  // namespace mesecina
