// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/element_facts.h"

#include <QRegularExpression>
#include <QStringList>
#include <algorithm>
#include <iterator>
#include <utility>

#include "core/formats/number.h"
#include "layers/panel_paint.h"

namespace mesecina {

std::vector<Fact> own_facts(const Primitive_set& set, std::size_t element) {
  std::vector<Fact> facts;
  facts.push_back({"id", std::to_string(set.id(element))});
  for (const Values& values : set.values) {
    if (element >= values.data.size()) continue;
    std::string text = format_number(values.data[element]);
    if (!values.unit.empty()) text += " " + values.unit;
    facts.push_back({values.name, std::move(text)});
  }
  return facts;
}

void add_facts(std::vector<Fact>& told, std::vector<Fact> more) {
  // A layer may describe what is among its values already.
  std::erase_if(more, [&](const Fact& fact) { return std::ranges::count(told, fact.name, &Fact::name) > 0; });
  told.insert(told.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
}

QString facts_text(const std::string& label, const std::vector<Fact>& facts) {
  QStringList lines{QString::fromStdString(label)};
  for (const Fact& fact : facts)
    lines << QStringLiteral("%1: %2").arg(QString::fromStdString(fact.name), QString::fromStdString(fact.text));
  return lines.join(QLatin1Char('\n'));
}

QString with_short_numbers(const QString& text) {
  static const QRegularExpression number(QStringLiteral("-?\\d+\\.\\d{3,}(e[+-]?\\d+)?"));
  constexpr int digits = 6;
  QString result;
  qsizetype end = 0;
  for (auto matches = number.globalMatch(text); matches.hasNext();) {
    const QRegularExpressionMatch match = matches.next();
    result += text.mid(end, match.capturedStart() - end) + short_number(match.captured().toDouble(), digits);
    end = match.capturedEnd();
  }
  return result + text.mid(end);
}

}  // namespace mesecina
