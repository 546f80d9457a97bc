// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

#include "core/formats/format.h"
#include "core/formats/settings_file.h"
#include "tests/formats/temporary_folder.h"

namespace mesecina {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

class Settings_files : public testing::Test {
 protected:
  Settings_files() {
    registry.begin_module({"module", "Module", "For tests."});
    registry.add_setting({"limit", "Limit", "", "", 0.5, 0, 1, {}, {}});
    registry.add_setting({"count", "Count", "", "", std::int64_t{3}, 0, 9, {}, {}});
    registry.add_setting({"kind", "Kind", "", "", std::string("a"), 0, 0, {"a", "b"}, {}});
  }
  std::string written(const Settings& settings, const std::vector<std::string>& ids) {
    std::ostringstream stream;
    write_settings_file(stream, registry, settings, ids);
    return stream.str();
  }
  Settings_file read(const std::string& text) {
    return read_settings_file(folder.write("settings.json", text), registry);
  }
  std::string refusal(const std::string& text) {
    try {
      read(text);
    } catch (const File_error& error) {
      return error.what();
    }
    return "";
  }
  Registry registry;
  Temporary_folder folder;
};

TEST_F(Settings_files, what_was_saved_comes_back_and_the_rest_stays) {
  const Settings saved = Settings{}.with("limit", 1.0 / 3).with("kind", std::string("b"));
  const Settings_file file = read(written(saved, {"limit", "count"}));
  EXPECT_THAT(file.ids, ElementsAre("count", "limit"));
  EXPECT_TRUE(file.notes.empty());
  // A default in the file resets; what is not in the file is not touched.
  const Settings now = Settings{}.with("count", std::int64_t{7}).with("kind", std::string("b"));
  EXPECT_EQ(with_settings_of(file, now), Settings{}.with("limit", 1.0 / 3).with("kind", std::string("b")));
}

TEST_F(Settings_files, a_name_that_is_not_known_is_told) {
  const Settings_file file =
      read(R"({"format": "mesecina-settings", "version": 1, "settings": {"limt": 0.2, "count": 4}})");
  ASSERT_EQ(file.notes.size(), 1U);
  EXPECT_THAT(file.notes.front(), HasSubstr("limt"));
  EXPECT_THAT(file.ids, ElementsAre("count"));
}

TEST_F(Settings_files, bad_files_are_refused_with_what_is_wrong) {
  EXPECT_THAT(refusal("{"), HasSubstr("expected JSON"));
  EXPECT_THAT(refusal("[]"), HasSubstr("mesecina-settings"));
  EXPECT_THAT(refusal(std::string(200000, '[') + std::string(200000, ']')), HasSubstr("at most 500 lists"));
  EXPECT_THAT(refusal(R"({"format": "mesecina-settings", "version": 2, "settings": {}})"), HasSubstr("newer"));
  EXPECT_THAT(refusal(R"({"format": "mesecina-settings", "version": 1})"), HasSubstr("found none"));
  EXPECT_THAT(refusal(R"({"format": "mesecina-settings", "version": 1, "settings": {"limit": 2}})"),
              HasSubstr("limit"));
  EXPECT_THROW(read_settings_file(folder.path() / "missing.json", registry), File_error);
}

}  // namespace
}  // namespace mesecina
