// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <ostream>

#include "tests/formats/temporary_folder.h"

namespace mesecina {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

constexpr uid_t nobody = 65534;

/// Root may read and write everything; becomes somebody else for a while.
class Without_privileges {
 public:
  Without_privileges() : was_root_(geteuid() == 0) {
    if (was_root_ && seteuid(nobody) != 0) ADD_FAILURE() << "cannot drop privileges";
  }
  ~Without_privileges() {
    if (was_root_ && seteuid(0) != 0) ADD_FAILURE() << "cannot take privileges back";
  }

 private:
  bool was_root_;
};

std::string error_of(const std::function<void()>& action) {
  try {
    action();
  } catch (const File_error& error) {
    return error.what();
  }
  return "";
}

std::string read_error(const std::filesystem::path& file) {
  return error_of([&] { read_file(planar_formats(), file); });
}

TEST(Read_file, MissingFilesAndFolders) {
  const Temporary_folder folder;
  const auto missing = folder.path() / "missing.xy";
  EXPECT_THAT(read_error(missing),
              AllOf(StartsWith(missing.string() + ": expected a file, found nothing"), HasSubstr("; ")));
  EXPECT_THAT(read_error(folder.path()), StartsWith(folder.path().string() + ": expected a file, found a folder"));
  std::filesystem::create_directory(folder.path() / "folder.wkt");
  EXPECT_THAT(read_error(folder.path() / "folder.wkt"), HasSubstr("expected a file, found a folder"));
  EXPECT_THAT(read_error("/dev/null"), HasSubstr("found a device"));
}

TEST(Read_file, UnreadableFiles) {
  const Temporary_folder folder;
  const auto file = folder.write("secret.xy", "1 2\n");
  std::filesystem::permissions(file, std::filesystem::perms::none);
  const Without_privileges guard;
  EXPECT_THAT(read_error(file), HasSubstr("expected a file that may be read, found no permission"));
}

TEST(Read_file, UnknownExtensions) {
  const Temporary_folder folder;
  EXPECT_EQ(folder.error("a.doc", "1 2"),
            "a.doc: expected one of the extensions .csv .geojson .json .poff .svg .txt .wkt .wpoff .xy .xyz, found "
            "'.doc'; rename or convert the file");
  EXPECT_THAT(folder.error("plain", "1 2"), HasSubstr("found nothing"));
}

TEST(Read_file, EmptyFilesOfEveryFormat) {
  const Temporary_folder folder;
  for (const Reader& reader : planar_formats().readers)
    for (const std::string& extension : reader.extensions)
      EXPECT_EQ(folder.error("a." + extension, ""),
                "a." + extension + ": expected data, found an empty file; write it again");
}

TEST(Read_file, ReaderForIsByExtensionInAnyCase) {
  const Formats formats = planar_formats();
  EXPECT_EQ(formats.reader_for("a.wkt"), formats.reader_for("/b/c.d.WKT"));
  ASSERT_NE(formats.reader_for("a.wkt"), nullptr);
  EXPECT_NE(formats.reader_for("a.wkt"), formats.reader_for("a.svg"));
  EXPECT_EQ(formats.reader_for("wkt"), nullptr);
  EXPECT_EQ(formats.reader_for(""), nullptr);
}

TEST(File_error_message, IsOneLine) {
  EXPECT_STREQ(File_error("a.xy", 3, "expected 1,\nfound 2").what(), "a.xy:3: expected 1, found 2");
  EXPECT_STREQ(File_error("a.xy", 0, "no").what(), "a.xy: no");
}

std::vector<std::string> names_in(const std::filesystem::path& folder) {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) names.push_back(entry.path().filename());
  return names;
}

TEST(Write_file, WritesTheWholeFileOrNothing) {
  const Temporary_folder folder;
  const auto file = folder.path() / "a.txt";
  write_file(file, [&](std::ostream& stream) {
    EXPECT_FALSE(std::filesystem::exists(file));
    stream << "first" << 1234567;
  });
  EXPECT_EQ(read_text(file), "first1234567");
  write_file(file, [&](std::ostream& stream) {
    stream << "2";
    stream.flush();
    EXPECT_EQ(read_text(file), "first1234567");
  });
  EXPECT_EQ(read_text(file), "2");
  EXPECT_THROW(write_file(file,
                          [](std::ostream& stream) {
                            stream << "half";
                            throw std::runtime_error("stop");
                          }),
               std::runtime_error);
  EXPECT_EQ(read_text(file), "2");
  EXPECT_THAT(names_in(folder.path()), ElementsAre("a.txt"));
}

TEST(Write_file, DoesNotTouchOtherFiles) {
  const Temporary_folder folder;
  const auto other = folder.write("a.txt.part0", "other");
  write_file(folder.path() / "a.txt", [](std::ostream& stream) { stream << "mine"; });
  EXPECT_EQ(read_text(other), "other");
  EXPECT_EQ(read_text(folder.path() / "a.txt"), "mine");
}

TEST(Write_file, Errors) {
  const Temporary_folder folder;
  const auto nothing = [](std::ostream&) {};
  const auto in_missing = folder.path() / "no" / "a.txt";
  EXPECT_THAT(error_of([&] { write_file(in_missing, nothing); }),
              AllOf(StartsWith(in_missing.string() + ": expected to create a file here, found"), HasSubstr("; check")));
  std::filesystem::create_directories(folder.path() / "b.txt" / "full");
  EXPECT_THAT(error_of([&] { write_file(folder.path() / "b.txt", nothing); }),
              HasSubstr("expected to replace this file"));
  EXPECT_THAT(error_of([&] {
                write_file(folder.path() / "c.txt", [](std::ostream& stream) { stream.setstate(std::ios::badbit); });
              }),
              HasSubstr("expected to write the whole file"));
  EXPECT_THAT(names_in(folder.path()), ElementsAre("b.txt"));
  std::filesystem::permissions(folder.path(), std::filesystem::perms::owner_read);
  {
    const Without_privileges guard;
    EXPECT_THAT(error_of([&] { write_file(folder.path() / "d.txt", nothing); }),
                HasSubstr("expected to create a file"));
  }
  std::filesystem::permissions(folder.path(), std::filesystem::perms::owner_all);
}

TEST(Data, EveryPlanarFileIsRead) {
  const char* data = std::getenv("MESECINA_DATA");
  if (!data) GTEST_SKIP() << "set MESECINA_DATA to a folder with real shapes in its subfolder 2d";
  std::size_t count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(std::filesystem::path(data) / "2d")) {
    SCOPED_TRACE(entry.path());
    File_contents contents;
    ASSERT_NO_THROW(contents = read_file(planar_formats(), entry.path()));
    ++count;
    const bool is_outline = entry.path().extension() == ".wkt";
    EXPECT_EQ(contents.inputs.ids(), std::vector<std::string>{is_outline ? "outline" : "points"});
    if (entry.path().stem() == "bad_selfcrossing_giraffe") {
      EXPECT_THAT(contents.warnings, ElementsAre(StartsWith("outline crosses itself 76 times, first near (61.5")));
    } else {
      EXPECT_THAT(contents.warnings, testing::IsEmpty());
    }
    if (!is_outline) continue;
    const Temporary_folder folder;
    const auto copy = folder.path() / "copy.wkt";
    const Formats formats = planar_formats();
    const auto writer = std::ranges::find(formats.input_writers, "wkt", &Input_writer::name);
    write_file(copy, [&](std::ostream& stream) { writer->write(stream, contents.inputs); });
    EXPECT_EQ(*read_file(formats, copy).inputs.get(outline_input), *contents.inputs.get(outline_input));
  }
  EXPECT_GE(count, 30u);
}

}  // namespace
}  // namespace mesecina
