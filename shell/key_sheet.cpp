// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/key_sheet.h"

#include <QDialog>
#include <QDialogButtonBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QScrollArea>
#include <QShortcut>
#include <QVBoxLayout>
#include <algorithm>
#include <memory>
#include <vector>

namespace mesecina {

namespace {

QString row(const QString& keys, const QString& text) {
  return QStringLiteral("<tr><td style='padding-right:14px; white-space:nowrap'><b>%1</b></td><td>%2</td></tr>")
      .arg(keys.toHtmlEscaped(), text.toHtmlEscaped());
}

QString heading(const QString& text) {
  return QStringLiteral("<tr><td colspan='2' style='padding-top:8px'><i>%1</i></td></tr>").arg(text.toHtmlEscaped());
}

struct Group {
  QString name;
  QStringList rows;
};

/// The group of that name; a new last one if there is none.
Group& group_of(const QString& name, std::vector<Group>& groups) {
  const auto it = std::ranges::find(groups, name, &Group::name);
  if (it != groups.end()) return *it;
  groups.push_back({name, {}});
  return groups.back();
}

/// Groups below each other, in columns of at most so many rows where no group has more.
QStringList columns_of(const std::vector<Group>& groups, int most_rows) {
  QStringList columns;
  int used = most_rows;
  for (const Group& group : groups) {
    const int needed = static_cast<int>(group.rows.size()) + 1;
    if (used + needed > most_rows) {
      columns << QString();
      used = 0;
    }
    columns.last() += heading(group.name) + group.rows.join(QString());
    used += needed;
  }
  return columns;
}

QDialog* make_sheet(const QString& title, QWidget* parent) {
  auto* sheet = new QDialog(parent);
  sheet->setModal(false);
  sheet->setAttribute(Qt::WA_DeleteOnClose);
  sheet->setWindowTitle(title);
  return sheet;
}

QLabel* column_of(const QString& rows) {
  auto* label = new QLabel(QStringLiteral("<table cellspacing='1'>%1</table>").arg(rows));
  label->setTextFormat(Qt::RichText);
  label->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  return label;
}

std::unique_ptr<QWidget> content_of(const QStringList& columns, int spacing) {
  auto content = std::make_unique<QWidget>();
  auto* row_of_columns = new QHBoxLayout(content.get());
  row_of_columns->setSpacing(spacing);
  for (const QString& column : columns) row_of_columns->addWidget(column_of(column), 0, Qt::AlignTop);
  return content;
}

}  // namespace

QWidget* make_key_sheet(const Actions& actions, const std::vector<Gesture>& gestures, QWidget* parent) {
  QDialog* sheet = make_sheet(QObject::tr("Keys and mouse"), parent);
  std::vector<Group> groups;
  Group& mouse = group_of(QObject::tr("Mouse"), groups);
  for (const auto& [keys, text] : gestures) mouse.rows << row(keys, text);
  for (const Actions::Entry& entry : actions.entries()) {
    if (entry.action->shortcuts().isEmpty()) continue;
    const QString keys = QKeySequence::listToString(entry.action->shortcuts(), QKeySequence::NativeText)
                             .replace(QStringLiteral("; "), QStringLiteral(", "));
    group_of(entry.group, groups).rows << row(keys, entry.name);
  }
  const int em = sheet->fontMetrics().height();
  constexpr int least_rows = 20;
  constexpr int frame = 6;  // of the window, in rows
  int rows = std::max(least_rows, (parent ? parent->height() : 0) / (em + 1) - frame);
  QStringList columns = columns_of(groups, rows);
  std::unique_ptr<QWidget> content = content_of(columns, em * 2);
  // What does not fit is below, where the wheel leads, not beside.
  while (parent && columns.size() > 1 && content->sizeHint().width() + em * 3 > parent->width()) {
    columns = columns_of(groups, ++rows);
    content = content_of(columns, em * 2);
  }
  auto* area = new QScrollArea(sheet);
  const QSize wanted = content->sizeHint() + QSize(em * 3, em * 3);
  area->setWidget(content.release());
  area->setFrameShape(QFrame::NoFrame);
  area->setWidgetResizable(true);
  auto* layout = new QVBoxLayout(sheet);
  layout->addWidget(area);
  sheet->resize(parent ? wanted.boundedTo(parent->size()) : wanted);
  sheet->show();
  return sheet;
}

QWidget* make_about(const QString& program, const QStringList& details, QWidget* parent) {
  QDialog* about = make_sheet(QObject::tr("About %1").arg(program), parent);
  auto* text = new QLabel(about);
  text->setTextFormat(Qt::RichText);
  text->setTextInteractionFlags(Qt::TextBrowserInteraction);
  text->setText(
      QObject::tr("<h2>Mesecina</h2>"
                  "<p>An explorer of geometric structures: Voronoi diagrams, crusts, medial axes<br>"
                  "and their filtrations, which follow the points under your mouse.</p>"
                  "<p>Free software under the GNU General Public License, version 3 or later.<br>"
                  "Built on CGAL, Qt, libQGLViewer, TBB, GLM and nlohmann-json.</p>") +
      QStringLiteral("<p>%1</p>")
          .arg(details.join(QLatin1Char('\n')).toHtmlEscaped().replace(QLatin1Char('\n'), QStringLiteral("<br>"))));
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, about);
  QObject::connect(buttons, &QDialogButtonBox::rejected, about, &QWidget::close);
  auto* layout = new QVBoxLayout(about);
  layout->addWidget(text);
  layout->addWidget(buttons);
  about->show();
  return about;
}

}  // namespace mesecina
