// SPDX-License-Identifier: GPL-3.0-or-later
#include <QRegularExpression>
#include <QScrollBar>
#include <QTextBrowser>
#include <QWhatsThis>
#include <QtTest>
#include <algorithm>

#include "core/help_text.h"
#include "geometries/modules_2.h"
#include "tests/widget_walk.h"
#include "window_fixture.h"

namespace mesecina {
namespace {

class Manual_in_window : public Window_fixture {
 protected:
  Manual_window& manual() {
    if (!window().manual()) trigger("manual");
    return *window().manual();
  }
  QString body(const char* id) {
    for (const Manual_page& page : manual().manual().pages())
      if (page.id == QLatin1String(id)) return page.body;
    return {};
  }
};

TEST_F(Manual_in_window, NothingIsMissingAndNoLinkIsDead) {
  const Manual& pages = manual().manual();
  EXPECT_TRUE(pages.faults().isEmpty()) << pages.faults().join('\n').toStdString();
  const auto registry = make_registry_2();
  for (const Layer_spec& spec : registry->layers())
    EXPECT_TRUE(body("layers").contains(QString::fromStdString(with_labels(spec.help, *registry)).toHtmlEscaped()))
        << spec.id;
  for (const Setting_spec& spec : registry->settings())
    EXPECT_TRUE(body("settings").contains(QString::fromStdString(with_labels(spec.help, *registry)).toHtmlEscaped()))
        << spec.id;
  for (const Evolution_spec& spec : registry->evolutions())
    EXPECT_TRUE(
        body("evolutions-list").contains(QString::fromStdString(with_labels(spec.help, *registry)).toHtmlEscaped()))
        << spec.id;
  for (const Command& command : window().commands().list()) {
    EXPECT_TRUE(body("commands").contains(QStringLiteral("command-%1\"").arg(command.id))) << command.id.toStdString();
    EXPECT_TRUE(body("commands").contains(command.help.toHtmlEscaped())) << command.id.toStdString();
  }
  EXPECT_TRUE(body("options").contains("name=\"option---nogui\""));
  EXPECT_TRUE(body("formats").contains(".poff"));
  EXPECT_GE(pages.figures().size(), 6u);
}

TEST_F(Manual_in_window, EveryTargetOfALinkIsAnAnchorOfItsPage) {
  const Manual& pages = manual().manual();
  static const QRegularExpression links(QStringLiteral("href=\"((?!https)[^\"]*)\""));
  int count = 0;
  for (const Manual_page& page : pages.pages()) {
    for (auto it = links.globalMatch(page.body); it.hasNext();) {
      const QString link = it.next().captured(1);
      const auto [id, anchor] = pages.target(link);
      ++count;
      if (anchor.isEmpty()) continue;
      EXPECT_TRUE(body(id.toUtf8().constData()).contains(QStringLiteral("<a name=\"%1\"></a>").arg(anchor)))
          << link.toStdString();
    }
  }
  EXPECT_GT(count, 50);
  EXPECT_EQ(pages.target("layer:no-such-layer").first, QString());
}

TEST_F(Manual_in_window, ShowsPagesFollowsLinksAndSearches) {
  EXPECT_EQ(manual().page(), "first-steps");
  manual().go_to("layer:medial-axis");
  EXPECT_EQ(manual().page(), "layers");
  manual().search("topology-preserving");
  ASSERT_FALSE(manual().listed().isEmpty());
  EXPECT_TRUE(manual().listed().front().contains("Preserve topology"));
  manual().search("--sweep");
  ASSERT_FALSE(manual().listed().isEmpty());
  EXPECT_TRUE(manual().listed().front().contains("--sweep")) << manual().listed().front().toStdString();
  manual().search("xyzzyx");
  EXPECT_TRUE(manual().listed().isEmpty());
  manual().search("");
  EXPECT_EQ(manual().listed().size(), static_cast<qsizetype>(manual().manual().pages().size()));
}

TEST_F(Manual_in_window, PagesShowPicturesThatFit) {
  manual().resize(900, 700);
  manual().go_to("chapter:recording");
  auto* browser = manual().findChild<QTextBrowser*>();
  const auto picture_of = [&](const char* figure) {
    return browser->document()
        ->resource(QTextDocument::ImageResource, QUrl(manual().manual().shipped_picture(figure)))
        .value<QImage>();
  };
  const QImage wide = picture_of("record");
  ASSERT_FALSE(wide.isNull());
  EXPECT_TRUE(browser->toHtml().contains(manual().manual().shipped_picture("record")));
  EXPECT_LE(wide.width(), browser->viewport()->width() * browser->devicePixelRatioF());
  EXPECT_FALSE(browser->horizontalScrollBar()->isVisible());
  browser->verticalScrollBar()->setValue(browser->verticalScrollBar()->maximum() / 2);
  manual().resize(600, 500);
  EXPECT_LT(picture_of("record").width(), wide.width());
  EXPECT_GT(browser->verticalScrollBar()->value(), 0);
}

TEST_F(Manual_in_window, APictureOfAnotherRecipeIsAFault) {
  const Manual& pages = manual().manual();
  for (const Manual_figure& figure : pages.figures()) {
    const QImage picture(pages.shipped_picture(figure.name));
    EXPECT_EQ(picture.text(recipe_key), figure.recipe()) << figure.name.toStdString();
    EXPECT_GE(picture.width(), 600) << figure.name.toStdString();
  }
  Manual_figure changed = pages.figures().front();
  changed.options << "--set"
                  << "lambda-limit=3";
  EXPECT_NE(changed.recipe(), pages.figures().front().recipe());
}

TEST_F(Manual_in_window, ThereAreChaptersForTasks) {
  for (const char* id : {"evolutions", "bundles", "recording", "sessions", "many-shapes"})
    EXPECT_GE(body(id).count("<h2>"), 4) << id;
}

TEST_F(Manual_in_window, AFigureIsShownInTheWindow) {
  auto* browser = manual().findChild<QTextBrowser*>();
  Q_EMIT browser->anchorClicked(QUrl("figure:scale-axis"));
  ASSERT_TRUE(wait_until([&] { return document().settings().find("scale") != nullptr; }));
  EXPECT_EQ(std::get<double>(*document().settings().find("scale")), 1.3);
  EXPECT_TRUE(find_entry(document().layers(), "scale-axis")->style.visible);
  EXPECT_FALSE(find_entry(document().layers(), "voronoi")->style.visible);
  EXPECT_TRUE(window().messages().lines().isEmpty());
}

TEST_F(Manual_in_window, EveryControlHasATipAndAName) {
  trigger("palette");
  trigger("shortcuts");
  trigger("select-all");
  trigger("coordinates");
  ASSERT_NE(window().popover(), nullptr);
  EXPECT_TRUE(faults_of_controls(window()).isEmpty()) << faults_of_controls(window()).join('\n').toStdString();
  EXPECT_TRUE(faults_of_controls(manual()).isEmpty()) << faults_of_controls(manual()).join('\n').toStdString();
}

TEST_F(Manual_in_window, WhatsThisSaysWhatTheTipSays) {
  auto* field = window().settings_panel().findChild<QAbstractSpinBox*>();
  ASSERT_NE(field, nullptr);
  QHelpEvent query(QEvent::QueryWhatsThis, QPoint(2, 2), field->mapToGlobal(QPoint(2, 2)));
  QApplication::sendEvent(field, &query);
  EXPECT_TRUE(query.isAccepted());
  EXPECT_EQ(field->whatsThis(), field->toolTip());
}

}  // namespace
}  // namespace mesecina
