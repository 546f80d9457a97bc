// SPDX-License-Identifier: GPL-3.0-or-later
#include <QImage>
#include <QSignalSpy>

#include "shell/script_runner.h"
#include "tests/widget_walk.h"
#include "window_fixture_3.h"

namespace mesecina {
namespace {

class Commands_3 : public Window_3 {
 protected:
  QString play(const QString& text) {
    Script_runner runner(*window_, QStringLiteral("test.txt"), text);
    QSignalSpy finished(&runner, &Script_runner::finished);
    runner.start();
    if (!wait_until([&] { return finished.count() > 0; })) return QStringLiteral("...");
    return finished.front().at(0).toString();
  }
};

TEST_F(Commands_3, AScriptBuildsASceneAndWritesAPicture) {
  const QString picture = folder_.filePath("balls.png");
  const QString view = folder_.filePath("balls.view.json");
  EXPECT_EQ(play(QStringLiteral("new\nadd-ball 0 0 0 1\nadd-ball 2 0 0 1.5\nadd-point 0 1 3\nselect-balls 1\n"
                                "move 0 1 0\nresize 2\nsolo given-balls\nview fit\ncutting-plane on\n"
                                "export-picture '%1' 320x240\nsave-view '%2'\nundo 2\n")
                     .arg(picture, view)),
            "");
  const auto balls = window_->document().inputs().get(balls_input);
  ASSERT_NE(balls, nullptr);
  EXPECT_EQ(*balls, (std::vector<Ball_3>{{{0, 0, 0}, 1}, {{2, 1, 0}, 1.5}}));
  EXPECT_EQ(window_->document().inputs().get(cloud_input)->size(), 1u);
  EXPECT_EQ(QImage(picture).size(), QSize(320, 240));
  EXPECT_TRUE(viewer().view().cutting_plane.has_value());
  const View_3 seen = viewer().view();
  EXPECT_EQ(play(QStringLiteral("view-top\nview '%1'").arg(view)), "");
  EXPECT_NEAR(viewer().view().camera.position.z, seen.camera.position.z, 1e-9);
  EXPECT_NEAR(viewer().view().camera.position.x, seen.camera.position.x, 1e-9);
}

TEST_F(Commands_3, ErrorsNameTheLine) {
  EXPECT_EQ(play("add-point 1 2 3\nview nowhere.json"),
            "test.txt:2: view: expected fit, a view file or its text, found 'nowhere.json'");
  EXPECT_TRUE(play("view {}").startsWith("test.txt:1: view: "));
  EXPECT_EQ(play("select-balls 99").left(12), "test.txt:1: ");
  EXPECT_TRUE(play("shwo mesh").contains("did you mean 'show'"));
}

TEST_F(Commands_3, EveryActionIsACommand) {
  for (const Actions::Entry& entry : window_->actions().entries())
    EXPECT_NO_THROW(window_->commands().find(entry.action->objectName())) << entry.action->objectName().toStdString();
  window_->actions()["palette"]->trigger();
  ASSERT_NE(window_->command_palette(), nullptr);
  window_->command_palette()->set_query("delta=0.05");
  ASSERT_FALSE(window_->command_palette()->items().empty());
  EXPECT_EQ(window_->command_palette()->items().front().key, "setting/delta");
}

TEST_F(Commands_3, TheManualIsCompleteAndEveryControlHasATip) {
  window_->actions()["manual"]->trigger();
  ASSERT_NE(window_->manual(), nullptr);
  const Manual& manual = window_->manual()->manual();
  EXPECT_TRUE(manual.faults().isEmpty()) << manual.faults().join('\n').toStdString();
  const auto registry = make_registry_3();
  for (const Layer_spec& spec : registry->layers())
    EXPECT_FALSE(manual.target("layer:" + QString::fromStdString(spec.id)).first.isEmpty()) << spec.id;
  for (const Evolution_spec& spec : registry->evolutions())
    EXPECT_FALSE(manual.target("evolution:" + QString::fromStdString(spec.id)).first.isEmpty()) << spec.id;
  window_->actions()["shortcuts"]->trigger();
  EXPECT_TRUE(faults_of_controls(*window_).isEmpty()) << faults_of_controls(*window_).join('\n').toStdString();
}

}  // namespace
}  // namespace mesecina
