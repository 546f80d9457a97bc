// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/fuzzy.h"

#include <QStringList>
#include <algorithm>

namespace mesecina {

namespace {

QString folded(const QString& text) {
  QString result;
  for (const QChar letter : text.normalized(QString::NormalizationForm_KD)) {
    if (letter.isMark()) continue;
    result += letter.toCaseFolded();
  }
  return result;
}

QStringList words_of(const QString& query) { return folded(query).split(QLatin1Char(' '), Qt::SkipEmptyParts); }

bool begins_word(const QString& text, qsizetype at) { return at == 0 || !text[at - 1].isLetterOrNumber(); }

/// Of one folded word in a folded text.
int word_score(const QString& word, const QString& text) {
  constexpr int whole_word = 100;
  constexpr int start_of_word = 80;
  constexpr int within = 50;
  constexpr int beginnings = 40;
  int best = 0;
  for (qsizetype at = text.indexOf(word); at >= 0; at = text.indexOf(word, at + 1)) {
    const qsizetype end = at + word.size();
    const bool ends_word = end == text.size() || !text[end].isLetterOrNumber();
    best = std::max(best, begins_word(text, at) ? (ends_word ? whole_word : start_of_word) : within);
  }
  if (best > 0) return best;
  // Letters apart: each begins a word, or goes on where the last one was.
  qsizetype at = -1;
  for (const QChar letter : word) {
    if (at + 1 < text.size() && at >= 0 && text[at + 1] == letter) {
      ++at;
      continue;
    }
    do {
      at = text.indexOf(letter, at + 1);
    } while (at >= 0 && !begins_word(text, at));
    if (at < 0) return 0;
  }
  return beginnings;
}

int score_of(const QStringList& words, const QString& text) {
  int sum = 0;
  for (const QString& word : words) {
    const int score = word_score(word, text);
    if (score == 0) return 0;
    sum += score;
  }
  return sum;
}

}  // namespace

int fuzzy_score(const QString& query, const QString& text) {
  const QStringList words = words_of(query);
  return words.isEmpty() ? 1 : score_of(words, folded(text));
}

int fuzzy_score(const QString& query, const QString& name, const QString& id, const QString& text) {
  const QStringList words = words_of(query);
  if (words.isEmpty()) return 1;
  const QString folded_name = folded(name);
  const QString folded_id = folded(id);
  const QString folded_text = folded(text);
  constexpr int name_factor = 4;
  constexpr int id_factor = 3;
  int sum = 0;
  for (const QString& word : words) {
    const int in_text = folded_text.contains(word) ? 1 : 0;
    const int score = std::max({name_factor * word_score(word, folded_name), id_factor * word_score(word, folded_id),
                                in_text * (word_score(word, folded_text) / 2)});
    if (score == 0) return 0;
    sum += score;
  }
  // Of two names with the same words the shorter one is meant.
  constexpr int longest = 64;
  return sum * longest - static_cast<int>(std::min<qsizetype>(name.size(), longest - 1));
}

}  // namespace mesecina
