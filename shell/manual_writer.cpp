// SPDX-License-Identifier: GPL-3.0-or-later
#include <QCoreApplication>
#include <QDir>
#include <QImage>
#include <QTemporaryDir>
#include <iostream>
#include <ostream>

#include "core/batch/batch.h"
#include "shell/manual.h"

namespace mesecina {

namespace {

QString tr(const char* text) { return QCoreApplication::translate("manual", text); }

constexpr const char* style_sheet =
    "body { font-family: sans-serif; line-height: 1.45; margin: 0; display: flex; color: #222; background: #fff }\n"
    "nav { flex: 0 0 13em; padding: 1.5em; background: #f2f3f5; min-height: 100vh }\n"
    "nav a { display: block; margin: .4em 0 } a { color: #1b5fa8; text-decoration: none }\n"
    "main { padding: 1.5em 2.5em; max-width: 48em } code, pre { background: #f2f3f5; padding: 0 .2em }\n"
    "pre { padding: .8em; overflow-x: auto } figure { margin: 1.2em 0 } figcaption { font-size: .9em }\n"
    "img { max-width: 100%; border: 1px solid #ddd } td, th { vertical-align: top; padding: .2em .6em .2em 0 }\n"
    "@media (prefers-color-scheme: dark) { body { color: #ddd; background: #1d1f21 } a { color: #7db4f0 }\n"
    "nav, code, pre { background: #2a2d30 } }\n";

QString contents(const Manual& manual, const QString& current) {
  QString text;
  for (const Manual_page& page : manual.pages()) {
    const QString title = page.title.toHtmlEscaped();
    text += page.id == current ? QStringLiteral("<b>%1</b>\n").arg(title)
                               : QStringLiteral("<a href=\"%1.html\">%2</a>\n").arg(page.id, title);
  }
  return text;
}

void write_text(const std::filesystem::path& file, const QString& text) {
  write_file(file, [&](std::ostream& out) { out << text.toStdString(); });
}

QString document(const QString& title, const QString& navigation, const QString& body) {
  return QStringLiteral(
             "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
             "<meta name=\"viewport\" content=\"width=device-width\">\n<title>%1</title>\n"
             "<link rel=\"stylesheet\" href=\"manual.css\">\n</head>\n<body>\n<nav>\n%2</nav>\n<main>\n")
             .arg(title.toHtmlEscaped(), navigation) +
         body + QStringLiteral("</main>\n</body>\n</html>\n");
}

/// With its recipe; false where there is no picture.
bool save_picture(QImage picture, const Manual_figure& figure, const std::filesystem::path& folder) {
  picture.setText(QLatin1String(recipe_key), figure.recipe());
  return picture.save(QString::fromStdString((folder / (figure.name.toStdString() + ".png")).string()));
}

}  // namespace

bool make_manual_pictures(const Manual_subject& subject, const std::shared_ptr<const Registry>& registry,
                          const std::filesystem::path& folder,
                          const std::function<void(const QString& name, const QString& folder)>& write_example) {
  const std::filesystem::path pictures = folder / "pictures";
  const QString examples = QString::fromStdString((folder / "examples").string());
  std::filesystem::create_directories(pictures);
  std::filesystem::create_directories(folder / "examples");
  const QTemporaryDir work;
  bool is_complete = true;
  const Manual manual(subject);
  for (const Manual_figure& figure : manual.figures()) {
    QString file = manual.shipped_picture(figure.name);
    if (!figure.is_of_window()) {
      const QString input = QDir(examples).filePath(figure.input);
      if (!QFile::exists(input)) write_example(figure.input, examples);
      const QString made = work.filePath(figure.name);
      const auto command_line = parsed_arguments(
          subject, QStringList{QStringLiteral("--nogui"), input, QStringLiteral("--formats"), QStringLiteral("png"),
                               QStringLiteral("--size"), QStringLiteral("900x600"), QStringLiteral("--log"),
                               QStringLiteral("error"), QStringLiteral("--output"), made} +
                       figure.options);
      if (const auto* wanted = std::get_if<Command_line>(&command_line))
        run_batch(*wanted, subject.program.toStdString(), registry, subject.formats, std::cerr, false);
      file = QStringLiteral("%1/%2.png").arg(made, QFileInfo(figure.input).completeBaseName());
    }
    if (save_picture(QImage(file), figure, pictures)) continue;
    std::cerr << subject.program.toStdString() << ": no picture of " << figure.name.toStdString() << '\n';
    is_complete = false;
  }
  return is_complete;
}

void write_manual(const Manual& manual, const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  write_text(folder / "manual.css", QString::fromLatin1(style_sheet));
  for (const Manual_page& page : manual.pages()) {
    write_text(folder / (page.id.toStdString() + ".html"),
               document(page.title, contents(manual, page.id), manual.file_body(page)));
  }
  write_text(folder / "index.html",
             document(tr("Manual"), contents(manual, {}),
                      QStringLiteral("<h1>%1</h1>\n").arg(tr("Manual")) + manual.file_body(manual.pages().front())));
}

}  // namespace mesecina
