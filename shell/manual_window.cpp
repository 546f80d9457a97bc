// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/manual_window.h"

#include <QDesktopServices>
#include <QLineEdit>
#include <QListWidget>
#include <QResizeEvent>
#include <QScrollBar>
#include <QShortcut>
#include <QSplitter>
#include <QTextBrowser>
#include <QUrl>
#include <QVBoxLayout>
#include <algorithm>
#include <functional>
#include <utility>

#include "shell/fuzzy.h"

namespace mesecina {

namespace {
enum Role { page_role = Qt::UserRole, anchor_role };
constexpr std::size_t most_found = 60;
constexpr int widest_picture = 720;
constexpr int narrowest_picture = 200;

/// Colours of what is code and of borders, between those of paper and ink.
QString page_style(const QPalette& palette) {
  const QColor code = palette.color(QPalette::AlternateBase);
  return QStringLiteral(
             "code, pre { background-color: %1 } pre { white-space: pre-wrap } "
             "h1 { font-size: xx-large } h2 { font-size: large } h3 { font-size: medium }")
      .arg(code.name());
}
}  // namespace

Manual_window::Manual_window(Manual manual, QWidget* parent)
    : QWidget(parent, Qt::Window),
      manual_(std::move(manual)),
      search_(new QLineEdit(this)),
      list_(new QListWidget(this)),
      text_(new QTextBrowser(this)) {
  setObjectName(QStringLiteral("manual-window"));
  setAttribute(Qt::WA_DeleteOnClose);
  setWindowTitle(tr("Manual"));
  search_->setPlaceholderText(tr("Search the manual"));
  search_->setClearButtonEnabled(true);
  search_->setAccessibleName(tr("Search the manual"));
  search_->setToolTip(tr("Words of a layer, a setting, a command or a chapter"));
  list_->setAccessibleName(tr("Contents"));
  list_->setToolTip(tr("Pages of the manual, or what was found"));
  text_->setAccessibleName(tr("Page"));
  text_->setToolTip(tr("A page of the manual"));
  text_->setOpenLinks(false);
  auto* side = new QWidget(this);
  auto* column = new QVBoxLayout(side);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(search_);
  column->addWidget(list_, 1);
  auto* parts = new QSplitter(this);
  parts->addWidget(side);
  parts->addWidget(text_);
  parts->setStretchFactor(1, 1);
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(parts);
  const int em = fontMetrics().height();
  constexpr int wide = 56;
  constexpr int high = 40;
  constexpr int side_width = 15;
  resize(wide * em, high * em);
  if (parent) resize(size().boundedTo(parent->size()));
  parts->setSizes({side_width * em, (wide - side_width) * em});
  text_->document()->setDocumentMargin(em);
  connect(search_, &QLineEdit::textChanged, this, &Manual_window::fill);
  connect(list_, &QListWidget::currentItemChanged, this, [this](QListWidgetItem* row) {
    if (row) show_page(row->data(page_role).toString(), row->data(anchor_role).toString());
  });
  connect(text_, &QTextBrowser::anchorClicked, this, &Manual_window::follow);
  connect(new QShortcut(QKeySequence(Qt::Key_Escape), this), &QShortcut::activated, this, &QWidget::close);
  fill();
  list_->setCurrentRow(0);
}

void Manual_window::fill() {
  const QString words = search_->text().trimmed();
  list_->clear();
  const auto add = [this](const QString& title, const QString& page, const QString& anchor) {
    auto* row = new QListWidgetItem(title, list_);
    row->setData(page_role, page);
    row->setData(anchor_role, anchor);
  };
  if (words.isEmpty()) {
    for (const Manual_page& page : manual_.pages()) add(page.title, page.id, {});
    return;
  }
  std::vector<std::pair<int, const Manual_section*>> found;
  for (const Manual_section& section : manual_.sections())
    if (const int score = fuzzy_score(words, section.title, section.anchor, section.text))
      found.emplace_back(score, &section);
  std::ranges::stable_sort(found, std::greater(), &std::pair<int, const Manual_section*>::first);
  if (found.size() > most_found) found.resize(most_found);
  for (const auto& [score, section] : found) {
    const auto page = std::ranges::find(manual_.pages(), section->page, &Manual_page::id);
    add(section->anchor.isEmpty() ? section->title : tr("%1 – %2").arg(section->title, page->title), section->page,
        section->anchor);
  }
}

void Manual_window::search(const QString& words) { search_->setText(words); }

QStringList Manual_window::listed() const {
  QStringList titles;
  for (int row = 0; row < list_->count(); ++row) titles << list_->item(row)->text();
  return titles;
}

void Manual_window::show_page(const QString& id, const QString& anchor) {
  const auto it = std::ranges::find(manual_.pages(), id, &Manual_page::id);
  if (it == manual_.pages().end()) return;
  if (std::exchange(page_, id) != id) lay_out();
  if (anchor.isEmpty()) {
    text_->moveCursor(QTextCursor::Start);
  } else {
    text_->scrollToAnchor(anchor);
  }
}

int Manual_window::picture_width() const {
  const int around =
      2 * static_cast<int>(text_->document()->documentMargin()) + text_->verticalScrollBar()->sizeHint().width();
  return std::clamp(text_->width() - around - 2 * text_->frameWidth(), narrowest_picture, widest_picture);
}

void Manual_window::lay_out() {
  const auto it = std::ranges::find(manual_.pages(), page_, &Manual_page::id);
  if (it == manual_.pages().end()) return;
  laid_out_width_ = picture_width();
  const int place = text_->verticalScrollBar()->value();
  text_->document()->clear();
  text_->document()->setDefaultStyleSheet(page_style(palette()));
  // Text documents scale pictures without smoothing, so they get them in the size in which they are shown.
  for (const Manual_figure& figure : manual_.figures()) {
    const QString name = manual_.shipped_picture(figure.name);
    if (!it->body.contains(QStringLiteral("name=\"%1\"").arg(figure.name))) continue;
    QImage picture =
        QImage(name).scaledToWidth(qRound(laid_out_width_ * devicePixelRatioF()), Qt::SmoothTransformation);
    picture.setDevicePixelRatio(devicePixelRatioF());
    text_->document()->addResource(QTextDocument::ImageResource, QUrl(name), picture);
  }
  text_->setHtml(manual_.window_body(*it, laid_out_width_));
  text_->verticalScrollBar()->setValue(place);
}

void Manual_window::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  if (picture_width() != laid_out_width_) lay_out();
}

void Manual_window::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) lay_out();
}

void Manual_window::go_to(const QString& link) {
  const auto [page, anchor] = manual_.target(link);
  if (!page.isEmpty()) show_page(page, anchor);
}

void Manual_window::follow(const QUrl& url) {
  const QString link = url.toString();
  if (url.scheme() == QLatin1String("https")) {
    QDesktopServices::openUrl(url);
  } else if (url.scheme() == QLatin1String("figure")) {
    if (const Manual_figure* figure = manual_.find_figure(link.section(QLatin1Char(':'), 1)))
      Q_EMIT figure_requested(*figure);
  } else {
    go_to(link);
  }
}

}  // namespace mesecina
