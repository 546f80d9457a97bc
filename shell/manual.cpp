// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/manual.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QImage>
#include <QRegularExpression>
#include <QTextDocumentFragment>
#include <algorithm>
#include <functional>
#include <set>
#include <utility>

#include "core/batch/command_line.h"
#include "core/help_text.h"
#include "layers/color_map.h"

// The macro needs the global namespace.
static void load_manual() { Q_INIT_RESOURCE(manual); }

namespace mesecina {

namespace {

QString tr(const char* text) { return QCoreApplication::translate("manual", text); }

QString escaped(const std::string& text) { return QString::fromStdString(text).toHtmlEscaped(); }

QString anchor(const QString& name) { return QStringLiteral("<a name=\"%1\"></a>").arg(name); }

/// The text with every match replaced by what `make` makes of it.
QString replaced(const QString& text, const QRegularExpression& pattern,
                 const std::function<QString(const QRegularExpressionMatch&)>& make) {
  QString result;
  qsizetype end = 0;
  for (auto it = pattern.globalMatch(text); it.hasNext();) {
    const QRegularExpressionMatch match = it.next();
    result += text.mid(end, match.capturedStart() - end) + make(match);
    end = match.capturedEnd();
  }
  return result + text.mid(end);
}

const QRegularExpression& link_pattern() {
  static const QRegularExpression pattern(QStringLiteral("href=\"([^\"]*)\""));
  return pattern;
}

const QRegularExpression& figure_pattern() {
  static const QRegularExpression pattern(
      QStringLiteral(
          "<figure name=\"([^\"]*)\"(?: input=\"([^\"]*)\" options=\"([^\"]*)\"| commands=\"([^\"]*)\")>(.*?)"
          "</figure>"),
      QRegularExpression::DotMatchesEverythingOption);
  return pattern;
}

Manual_figure figure_of(const QRegularExpressionMatch& match) {
  QStringList commands = match.captured(4).split(QLatin1Char(';'), Qt::SkipEmptyParts);
  for (QString& command : commands) command = command.simplified();
  return {match.captured(1), match.captured(2), match.captured(3).split(QLatin1Char(' '), Qt::SkipEmptyParts), commands,
          match.captured(5).simplified()};
}

}  // namespace

std::variant<Command_line, Early_exit> parsed_arguments(const Manual_subject& subject, const QStringList& arguments) {
  std::vector<std::string> words{subject.program.toStdString()};
  for (const QString& argument : arguments) words.push_back(argument.toStdString());
  std::vector<const char*> pointers;
  pointers.reserve(words.size());
  for (const std::string& word : words) pointers.push_back(word.c_str());
  std::vector<std::string> maps;
  for (const Color_map& map : color_maps()) maps.push_back(map.name());
  return parse_command_line(static_cast<int>(pointers.size()), pointers.data(), words.front(), subject.registry,
                            subject.formats, maps);
}

namespace {

QString range_text(const Setting_spec& spec) {
  QStringList parts{tr("usually %1").arg(escaped(to_text(spec.default_value)))};
  if (std::isfinite(spec.minimum)) parts << tr("at least %1").arg(spec.minimum);
  if (std::isfinite(spec.maximum)) parts << tr("at most %1").arg(spec.maximum);
  QStringList choices;
  for (const std::string& choice : spec.choices) choices << escaped(choice);
  if (!choices.isEmpty()) parts << tr("one of %1").arg(choices.join(QStringLiteral(", ")));
  if (!spec.unit.empty()) parts << tr("unit: %1").arg(escaped(spec.unit));
  return parts.join(QStringLiteral("; "));
}

QString entry(const QString& kind, const QString& id, const QString& name, const QString& text) {
  return QStringLiteral("<h3>%1%2 <code>%3</code></h3>\n<p>%4</p>\n")
      .arg(anchor(kind + QLatin1Char('-') + id), name.toHtmlEscaped(), id.toHtmlEscaped(), text);
}

QString table(const QStringList& headings, const QList<QStringList>& rows) {
  QString text = QStringLiteral("<table cellpadding=\"4\">\n<tr><th align=\"left\">%1</th></tr>\n")
                     .arg(headings.join(QStringLiteral("</th><th align=\"left\">")));
  for (const QStringList& row : rows)
    text += QStringLiteral("<tr><td>%1</td></tr>\n").arg(row.join(QStringLiteral("</td><td>")));
  return text + QStringLiteral("</table>\n");
}

}  // namespace

Manual::Manual(const Manual_subject& subject) : subject_(subject) {
  load_manual();
  add_chapters();
  add_layers();
  add_settings();
  if (!subject_.registry.evolutions().empty()) add_evolutions();
  if (subject_.commands) add_commands();
  add_formats();
  add_options();
}

void Manual::add_page(const QString& id, const QString& title, const QString& body) {
  anchors_[QStringLiteral("chapter:") + id] = id;
  // Headings without an anchor of their own get one, so that a search can lead there.
  int count = 0;
  static const QRegularExpression heading(QStringLiteral("<(h[23])>(?!<a name)"));
  const QString with_anchors = replaced(body, heading, [&](const QRegularExpressionMatch& match) {
    return QStringLiteral("<%1>").arg(match.captured(1)) + anchor(QStringLiteral("section-%1").arg(++count));
  });
  pages_.push_back({id, title, QStringLiteral("<h1>%1</h1>\n").arg(title.toHtmlEscaped()) + with_anchors});
  static const QRegularExpression start(QStringLiteral("<h[23]><a name=\"([^\"]*)\"></a>(.*?)</h[23]>"));
  const auto plain = [](const QString& html) { return QTextDocumentFragment::fromHtml(html).toPlainText(); };
  std::vector<QRegularExpressionMatch> starts;
  for (auto it = start.globalMatch(with_anchors); it.hasNext();) starts.push_back(it.next());
  const qsizetype first = starts.empty() ? with_anchors.size() : starts.front().capturedStart();
  sections_.push_back({id, {}, title, plain(with_anchors.left(first))});
  for (std::size_t i = 0; i < starts.size(); ++i) {
    const qsizetype end = i + 1 < starts.size() ? starts[i + 1].capturedStart() : with_anchors.size();
    static const QRegularExpression code(QStringLiteral("<code>(.*?)</code>"));
    const QString heading_html = starts[i].captured(2);
    sections_.push_back({id, starts[i].captured(1), plain(QString(heading_html).remove(code)).trimmed(),
                         code.match(heading_html).captured(1) + QLatin1Char(' ') +
                             plain(with_anchors.mid(starts[i].capturedEnd(), end - starts[i].capturedEnd()))});
  }
}

void Manual::add_chapters() {
  const bool is_planar = subject_.registry.dimension() == 2;
  const QString other = is_planar ? QStringLiteral(".3d.") : QStringLiteral(".2d.");
  static const QRegularExpression in_plane(QStringLiteral("<only2d>(.*?)</only2d>"),
                                           QRegularExpression::DotMatchesEverythingOption);
  static const QRegularExpression in_space(QStringLiteral("<only3d>(.*?)</only3d>"),
                                           QRegularExpression::DotMatchesEverythingOption);
  static const QRegularExpression title(QStringLiteral("<h1>(.*?)</h1>\\s*"));
  static const QRegularExpression comment(QStringLiteral("<!--.*?-->\\s*"),
                                          QRegularExpression::DotMatchesEverythingOption);
  for (const QString& name :
       QDir(QStringLiteral(":/manual")).entryList({QStringLiteral("*.html")}, QDir::Files, QDir::Name)) {
    if (name.contains(other)) continue;
    QFile file(QStringLiteral(":/manual/") + name);
    if (!file.open(QIODevice::ReadOnly)) continue;
    QString body = QString::fromUtf8(file.readAll());
    body.remove(comment);
    body.replace(is_planar ? in_plane : in_space, QStringLiteral("\\1")).remove(is_planar ? in_space : in_plane);
    body.replace(QStringLiteral("{program}"), subject_.program);
    body.replace(QStringLiteral("{example}"), is_planar ? QStringLiteral("giraffe.wkt") : QStringLiteral("ring.off"));
    const QString heading = title.match(body).captured(1);
    body.remove(title);
    for (auto it = figure_pattern().globalMatch(body); it.hasNext();) figures_.push_back(figure_of(it.next()));
    add_page(name.section(QLatin1Char('.'), 0, 0).section(QLatin1Char('-'), 1), heading, body);
  }
}

QString Manual::help_of(const std::string& help) const { return escaped(with_labels(help, subject_.registry)); }

void Manual::add_layers() {
  QString body = QStringLiteral("<p>%1</p>\n")
                     .arg(tr("Every layer of the program, stage by stage. The name in the second place is that of "
                             "--layers and of commands."));
  std::string stage;
  for (const Layer_spec& spec : subject_.registry.layers()) {
    if (spec.stage != stage) body += QStringLiteral("<h2>%1</h2>\n").arg(escaped(stage = spec.stage));
    QString text = help_of(spec.help);
    const auto add_setting = [&](const QString& words, const std::string& id) {
      if (!id.empty())
        text += QLatin1Char(' ') + words.arg(QStringLiteral("<a href=\"setting:%1\">%1</a>").arg(escaped(id)));
    };
    add_setting(tr("Elements are limited by %1."), spec.cut_setting);
    add_setting(tr("The switch %1 chooses how."), spec.cut_switch);
    const QString id = QString::fromStdString(spec.id);
    body += entry(QStringLiteral("layer"), id, QString::fromStdString(spec.label), text);
    anchors_[QStringLiteral("layer:") + id] = QStringLiteral("layers");
  }
  add_page(QStringLiteral("layers"), tr("Layers"), body);
}

void Manual::add_settings() {
  QString body =
      QStringLiteral("<p>%1</p>\n").arg(tr("Every number, switch and choice of the panel of settings and of --set."));
  const Module_spec* module = nullptr;
  for (const Setting_spec& spec : subject_.registry.settings()) {
    const Module_spec* own = subject_.registry.module_of(spec.id);
    if (own && own != module)
      body += QStringLiteral("<h2>%1</h2>\n<p>%2</p>\n").arg(escaped(own->label), help_of(own->help));
    module = own;
    const QString id = QString::fromStdString(spec.id);
    body += entry(QStringLiteral("setting"), id, QString::fromStdString(spec.label),
                  QStringLiteral("%1 <i>(%2)</i>").arg(help_of(spec.help), range_text(spec)));
    anchors_[QStringLiteral("setting:") + id] = QStringLiteral("settings");
  }
  add_page(QStringLiteral("settings"), tr("Settings"), body);
}

void Manual::add_evolutions() {
  QString body;
  for (const Evolution_spec& spec : subject_.registry.evolutions()) {
    QStringList settings;
    for (const std::string& id : spec.settings)
      settings << QStringLiteral("<a href=\"setting:%1\">%1</a>").arg(escaped(id));
    const QString id = QString::fromStdString(spec.id);
    const std::string& needs = spec.needs.what;
    body += entry(QStringLiteral("evolution"), id, QString::fromStdString(spec.label),
                  (needs.empty() ? QString() : tr("Needs %1.").arg(escaped(needs)) + QLatin1Char(' ')) +
                      help_of(spec.help) +
                      (settings.isEmpty() ? QString() : tr(" Settings: %1.").arg(settings.join(QStringLiteral(", ")))));
    anchors_[QStringLiteral("evolution:") + id] = QStringLiteral("evolutions-list");
  }
  add_page(QStringLiteral("evolutions-list"), tr("All evolutions"), body);
}

void Manual::add_commands() {
  QString body = QStringLiteral("<p>%1</p>\n")
                     .arg(tr("What menus, keys and the palette do, and what the lines of a script may say. [Square "
                             "brackets] stand around what may be left out; dots after what may be repeated."));
  QString group;
  for (const Command& command : subject_.commands->list()) {
    if (command.group != group) body += QStringLiteral("<h2>%1</h2>\n").arg((group = command.group).toHtmlEscaped());
    const Actions::Entry* action = subject_.commands->actions().find(command.id);
    QString text = command.help.toHtmlEscaped();
    if (action && !action->usual_keys.isEmpty())
      text += tr(" Keys: %1.")
                  .arg(QKeySequence::listToString(action->usual_keys, QKeySequence::PortableText)
                           .replace(QStringLiteral("; "), QStringLiteral(", "))
                           .toHtmlEscaped());
    QStringList parameters;
    for (const Parameter& parameter : command.parameters)
      parameters
          << QStringLiteral("<code>%1</code>: %2").arg(parameter.name.toHtmlEscaped(), parameter.help.toHtmlEscaped());
    if (!parameters.isEmpty())
      text += QStringLiteral("<br><code>%1</code><br>%2")
                  .arg(command.usage().toHtmlEscaped(), parameters.join(QStringLiteral("; ")));
    body += entry(QStringLiteral("command"), command.id, command.name, text);
    anchors_[QStringLiteral("command:") + command.id] = QStringLiteral("commands");
  }
  add_page(QStringLiteral("commands"), tr("Commands and keys"), body);
}

void Manual::add_formats() {
  const Formats& formats = subject_.formats;
  QList<QStringList> read;
  for (const Reader& reader : formats.readers) {
    QStringList extensions;
    for (const std::string& extension : reader.extensions) extensions << QStringLiteral(".") + escaped(extension);
    read << QStringList{extensions.join(QLatin1Char(' ')), escaped(reader.name)};
  }
  QList<QStringList> saved;
  for (const Input_writer& writer : formats.input_writers)
    saved << QStringList{QStringLiteral(".") + escaped(writer.extension), escaped(writer.input_id)};
  QList<QStringList> layers;
  for (const Layer_writer& writer : formats.layer_writers)
    layers << QStringList{escaped(writer.name), QStringLiteral(".") + escaped(writer.extension), escaped(writer.help)};
  QList<QStringList> pictures;
  for (const Picture_writer& writer : formats.picture_writers)
    pictures << QStringList{escaped(writer.name), QStringLiteral(".") + escaped(writer.extension),
                            escaped(writer.help)};
  add_page(QStringLiteral("formats"), tr("File formats"),
           QStringLiteral("<h2>%1</h2>\n").arg(tr("Read")) + table({tr("extension"), tr("what it holds")}, read) +
               QStringLiteral("<h2>%1</h2>\n").arg(tr("Saved data")) +
               table({tr("extension"), tr("what it holds")}, saved) +
               QStringLiteral("<h2>%1</h2>\n").arg(tr("Layers")) +
               table({tr("name"), tr("extension"), tr("what it holds")}, layers) +
               QStringLiteral("<h2>%1</h2>\n").arg(tr("Pictures")) +
               table({tr("name"), tr("extension"), tr("what it holds")}, pictures));
}

void Manual::add_options() {
  const auto help = parsed_arguments(subject_, {QStringLiteral("--help")});
  const auto* exit = std::get_if<Early_exit>(&help);
  const QString text = exit ? QString::fromStdString(exit->text).toHtmlEscaped() : QString();
  // Lines of an option begin with two spaces, those that go on with what it does are indented far.
  static const QRegularExpression option(QStringLiteral("^  ((?:-\\w,)?(--[\\w-]+)(?: ?\\S+)*)(?:\\s{2,}(.*))?$"));
  static const QRegularExpression heading(QStringLiteral("^(\\w+):$"));
  static const QRegularExpression more(QStringLiteral("^ {10,}(.*)$"));
  QString body;
  for (const QString& line : text.split(QLatin1Char('\n'), Qt::SkipEmptyParts)) {
    if (const auto match = option.match(line); match.hasMatch()) {
      anchors_[QStringLiteral("option:") + match.captured(2)] = QStringLiteral("options");
      body += QStringLiteral("<h3>%1%2</h3>\n%3\n")
                  .arg(anchor(QStringLiteral("option-") + match.captured(2)), match.captured(1), match.captured(3));
    } else if (const auto title = heading.match(line); title.hasMatch()) {
      body += QStringLiteral("<h2>%1</h2>\n").arg(title.captured(1));
    } else if (const auto rest = more.match(line); rest.hasMatch()) {
      body += rest.captured(1) + QLatin1Char('\n');
    } else {
      body += QStringLiteral("<p>%1</p>\n").arg(line.trimmed());
    }
  }
  add_page(QStringLiteral("options"), tr("Options of the command line"), body);
}

const Manual_figure* Manual::find_figure(const QString& name) const {
  const auto it = std::ranges::find(figures_, name, &Manual_figure::name);
  return it == figures_.end() ? nullptr : &*it;
}

std::pair<QString, QString> Manual::target(const QString& link) const {
  const auto it = anchors_.find(link);
  if (it == anchors_.end()) return {};
  const bool is_page = link.startsWith(QLatin1String("chapter:"));
  return {*it, is_page ? QString() : QString(link).replace(link.indexOf(QLatin1Char(':')), 1, QLatin1Char('-'))};
}

QString Manual::file_body(const Manual_page& page) const {
  const QString body = replaced(page.body, link_pattern(), [this](const QRegularExpressionMatch& match) {
    const auto [id, place] = target(match.captured(1));
    if (id.isEmpty()) return match.captured(0);
    return QStringLiteral("href=\"%1.html%2\"").arg(id, place.isEmpty() ? QString() : QLatin1Char('#') + place);
  });
  return replaced(body, figure_pattern(), [this](const QRegularExpressionMatch& match) {
    const Manual_figure figure = figure_of(match);
    const QString made_by = figure.is_of_window()
                                ? QString()
                                : QStringLiteral("<br><code>%1 --nogui %2 %3 --formats png</code>")
                                      .arg(subject_.program, figure.input, figure.options.join(QLatin1Char(' ')));
    return QStringLiteral(
               "<figure><img src=\"pictures/%1.png\" alt=\"%2\" width=\"600\"><figcaption>%2%3</figcaption></figure>")
        .arg(figure.name, figure.caption, made_by);
  });
}

QString Manual::window_body(const Manual_page& page, int picture_width) const {
  return replaced(page.body, figure_pattern(), [this, picture_width](const QRegularExpressionMatch& match) {
    const Manual_figure figure = figure_of(match);
    const QString link =
        figure.is_of_window()
            ? QString()
            : QStringLiteral(" <a href=\"figure:%1\">%2</a>").arg(figure.name, tr("Show this in the window"));
    return QStringLiteral("<p><img src=\"%1\" width=\"%2\"><br><i>%3.</i>%4</p>")
        .arg(shipped_picture(figure.name))
        .arg(picture_width)
        .arg(figure.caption, link);
  });
}

QString Manual::shipped_picture(const QString& figure) const {
  return QStringLiteral(":/manual/pictures/%1/%2.png").arg(subject_.program, figure);
}

QStringList Manual::faults() const {
  QStringList faults;
  std::set<QString> ids;
  for (const Manual_page& page : pages_) {
    if (!ids.insert(page.id).second) faults << tr("two pages are called %1").arg(page.id);
    if (page.title.isEmpty()) faults << tr("the page %1 has no title").arg(page.id);
    for (auto it = link_pattern().globalMatch(page.body); it.hasNext();) {
      const QString link = it.next().captured(1);
      if (!link.startsWith(QLatin1String("https://")) && target(link).first.isEmpty())
        faults << tr("%1: the link %2 leads nowhere").arg(page.id, link);
    }
  }
  const QStringList examples = subject_.commands
                                   ? subject_.commands->find(QStringLiteral("open-example")).parameters.front().known()
                                   : QStringList();
  for (const Manual_figure& figure : figures_) {
    const QString recipe = QImage(shipped_picture(figure.name)).text(QLatin1String(recipe_key));
    if (recipe != figure.recipe())
      faults << tr("the picture of the figure %1 was made by '%2', not by '%3': run scripts/make-manual-pictures")
                    .arg(figure.name, recipe, figure.recipe());
    if (figure.is_of_window()) continue;
    if (subject_.commands && !examples.contains(figure.input))
      faults << tr("the figure %1 is of %2, which is no example").arg(figure.name, figure.input);
    const auto command_line = parsed_arguments(subject_, figure.options);
    if (const auto* exit = std::get_if<Early_exit>(&command_line))
      faults << tr("the figure %1: %2").arg(figure.name, QString::fromStdString(exit->text).trimmed());
  }
  return faults;
}

QString Manual_figure::recipe() const {
  return is_of_window() ? commands.join(QStringLiteral("; "))
                        : input + QLatin1Char(' ') + options.join(QLatin1Char(' '));
}

QString figure_script(const Manual_figure& figure) {
  QStringList lines{QStringLiteral("open-example ") + quoted(figure.input), QStringLiteral("reset")};
  for (qsizetype i = 0; i + 1 < figure.options.size(); ++i) {
    const QString& option = figure.options[i];
    const QString& value = figure.options[i + 1];
    if (option == QLatin1String("--layers"))
      lines << QStringLiteral("solo ") + QString(value).replace(QLatin1Char(','), QLatin1Char(' '));
    if (option == QLatin1String("--set")) lines << QStringLiteral("set ") + quoted(value);
    if (option == QLatin1String("--style")) lines << QStringLiteral("style ") + quoted(value);
  }
  return lines.join(QLatin1Char('\n'));
}

}  // namespace mesecina
