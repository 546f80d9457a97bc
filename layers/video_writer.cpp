// SPDX-License-Identifier: GPL-3.0-or-later
#include "layers/video_writer.h"

#include <algorithm>
#include <optional>
#include <ostream>
#include <system_error>
#include <utility>
#include <vector>

#include "core/formats/format.h"
#include "core/formats/number.h"
#include "core/outcome.h"
#include "layers/encoder_process.h"
#include "layers/picture_formats.h"

namespace mesecina {

namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

constexpr const char* encoder = "ffmpeg";

void append(Words& words, const Words& more) { words.insert(words.end(), more.begin(), more.end()); }

/// Names with a colon or a dash are protocols or options to the encoder otherwise.
std::string file_word(const fs::path& file) { return "file:" + file.string(); }

std::string hexadecimal(const Color& color) {
  constexpr const char* digits = "0123456789abcdef";
  std::string text = "0x";
  for (const std::uint8_t part : {color.red, color.green, color.blue}) {
    text += digits[part >> 4];
    text += digits[part & 15];
  }
  return text;
}

/// From the pictures to the film.
Words encoding_words(const Film_request& request, Film_kind kind) {
  const std::string padding =
      "pad=ceil(iw/2)*2:ceil(ih/2)*2:color=" + hexadecimal(request.background) + (request.is_transparent ? "@0" : "");
  // Without saying so, players take colours for those of television of an older kind, or not, by their size.
  const std::string colors = ",scale=out_color_matrix=bt709:out_range=tv";
  const Words tags = {"-colorspace", "bt709", "-color_primaries", "bt709", "-color_trc", "bt709", "-color_range", "tv"};
  if (kind == Film_kind::mp4) {
    Words words = {"-vf", padding + colors, "-c:v",    "libx264",   "-preset",   "medium", "-crf",
                   "18",  "-pix_fmt",       "yuv420p", "-movflags", "+faststart"};
    append(words, tags);
    return words;
  }
  Words words = {"-vf",       padding + colors,
                 "-c:v",      "libvpx-vp9",
                 "-crf",      "24",
                 "-b:v",      "0",
                 "-deadline", "good",
                 "-cpu-used", "4",
                 "-row-mt",   "1",
                 "-pix_fmt",  request.is_transparent ? "yuva420p" : "yuv420p"};
  // Frames that are never shown cannot have alpha.
  if (request.is_transparent) append(words, {"-auto-alt-ref", "0"});
  append(words, tags);
  return words;
}

std::string palette_filter(const Film_request& request) {
  return std::string("palettegen=stats_mode=full:reserve_transparent=") + (request.is_transparent ? "1" : "0");
}

constexpr const char* use_of_palette = "paletteuse=dither=bayer:bayer_scale=5:alpha_threshold=128";

std::string quoted(const std::string& word) {
  std::string text = "'";
  for (const char c : word) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return text + "'";
}

/// What a user types to make the film of numbered pictures.
std::string command_of(const Film_request& request, Film_kind kind, const fs::path& pattern) {
  // In names of pictures % has a meaning, in folders too.
  std::string folder;
  for (const char c : (pattern.parent_path() / "").string()) folder += c == '%' ? std::string("%%") : std::string(1, c);
  std::string text = std::string(encoder) + " -framerate " + format_number(request.frames_per_second) + " -i " +
                     quoted(file_word(folder + pattern.filename().string()));
  if (kind == Film_kind::gif) {
    text += " -lavfi " + quoted("split[a][b];[a]" + palette_filter(request) + "[p];[b][p]" + use_of_palette);
  } else {
    for (const std::string& word : encoding_words(request, kind))
      text += " " + (word.find_first_of("()*; ") == std::string::npos ? word : quoted(word));
  }
  return text + " " + quoted(file_word(request.file));
}

class Video final : public Film {
 public:
  Video(Film_request request, Frame_painter paint);
  ~Video() override;
  void add(const Film_frame& frame, const std::stop_token& stop) override;
  std::string finish(const std::stop_token& stop) override;

 private:
  void begin_encoder();
  void make_gif(const std::stop_token& stop);
  void publish(const fs::path& from, const fs::path& to) const;
  template <class Work>
  auto named(const Work& work) const {
    try {
      return work();
    } catch (const File_error&) {
      throw;
    } catch (const std::runtime_error& error) {
      throw File_error(request_.file, 0, "no film can be made: " + std::string(error.what()));
    }
  }

  Film_request request_;
  Frame_painter paint_;
  Film_kind wanted_;
  Film_kind kind_;
  fs::path folder_;
  fs::path pattern_;  ///< of numbered pictures
  std::optional<Encoder_process> encoder_;
  int frames_ = 0;
};

Video::Video(Film_request request, Frame_painter paint)
    : request_(std::move(request)),
      paint_(std::move(paint)),
      wanted_(film_kind_of(request_.file).value_or(Film_kind::frames)),
      kind_(wanted_),
      folder_(unfinished_film(request_.file)),
      pattern_(request_.file) {
  std::error_code error;
  fs::remove_all(folder_, error);
  fs::create_directory(folder_, error);
  if (error) throw File_error(request_.file, 0, "expected to make files in its folder, found: " + error.message());
  if (kind_ == Film_kind::frames) return;
  try {
    begin_encoder();
  } catch (const Program_missing&) {
    kind_ = Film_kind::frames;
    std::string stem = request_.file.stem().string();
    std::ranges::replace(stem, '%', '_');
    pattern_ = request_.file.parent_path() / (stem + "-%05d.png");
  } catch (const std::runtime_error& problem) {
    fs::remove_all(folder_, error);
    throw File_error(request_.file, 0, problem.what());
  }
}

Video::~Video() {
  encoder_.reset();
  std::error_code error;
  fs::remove_all(folder_, error);
}

void Video::begin_encoder() {
  Words words = {encoder,
                 "-hide_banner",
                 "-loglevel",
                 "error",
                 "-y",
                 "-f",
                 "rawvideo",
                 "-pixel_format",
                 request_.is_transparent ? "rgba" : "bgr0",
                 "-video_size",
                 std::to_string(request_.width) + "x" + std::to_string(request_.height),
                 "-framerate",
                 format_number(request_.frames_per_second),
                 "-i",
                 "pipe:0"};
  if (kind_ == Film_kind::gif) {
    // A palette for all frames is known only after the last of them.
    append(words,
           {"-c:v", "ffv1", "-pix_fmt", request_.is_transparent ? "bgra" : "bgr0", file_word(folder_ / "frames.mkv")});
  } else {
    append(words, encoding_words(request_, kind_));
    words.push_back(file_word(folder_ / request_.file.filename()));
  }
  encoder_.emplace(words);
}

void Video::add(const Film_frame& frame, const std::stop_token& stop) {
  QImage picture = paint_(frame, request_.width, request_.height);
  if (picture.isNull())
    throw File_error(request_.file, 0,
                     "no memory for a picture of " + std::to_string(request_.width) + " x " +
                         std::to_string(request_.height) + " pixels");
  ++frames_;
  if (kind_ == Film_kind::frames) {
    const std::string bytes = png_bytes(picture);
    write_file(folder_ / frame_name(pattern_, frames_).filename(), [&](std::ostream& out) { out << bytes; });
    if (stop.stop_requested()) throw Cancelled();
    return;
  }
  picture.convertTo(request_.is_transparent ? QImage::Format_RGBA8888 : QImage::Format_RGB32);
  named([&] {
    encoder_->write(std::as_bytes(std::span(picture.constBits(), static_cast<std::size_t>(picture.sizeInBytes()))),
                    stop);
  });
}

void Video::make_gif(const std::stop_token& stop) {
  const std::string frames = file_word(folder_ / "frames.mkv");
  // A film of one picture: in the names of pictures, % has a meaning.
  const std::string palette = file_word(folder_ / "palette.mkv");
  const Words start = {encoder, "-hide_banner", "-loglevel", "error", "-nostdin", "-y", "-i", frames};
  Words words = start;
  append(words, {"-vf", palette_filter(request_), "-c:v", "ffv1", "-pix_fmt", "bgra", palette});
  encoder_.emplace(words).finish(stop);
  words = start;
  append(words, {"-i", palette, "-lavfi", use_of_palette, "-loop", "0", file_word(folder_ / request_.file.filename())});
  encoder_.emplace(words).finish(stop);
}

void Video::publish(const fs::path& from, const fs::path& to) const {
  std::error_code error;
  if (fs::is_directory(to, error)) throw File_error(to, 0, "expected to put a file here, found a folder; move it away");
  fs::rename(from, to, error);
  if (error) throw File_error(to, 0, "expected to put a file here, found: " + error.message());
}

std::string Video::finish(const std::stop_token& stop) {
  if (stop.stop_requested()) throw Cancelled();
  if (frames_ == 0) throw File_error(request_.file, 0, "expected at least one picture for a film, found none");
  if (kind_ == Film_kind::frames) {
    for (int i = 1; i <= frames_; ++i) {
      const fs::path place = frame_name(pattern_, i);
      publish(folder_ / place.filename(), place);
    }
    if (wanted_ == Film_kind::frames) return {};
    return request_.file.string() + ": there is no program ffmpeg to make it; the " + std::to_string(frames_) +
           " pictures are in " + pattern_.string() +
           "; this makes the film of them: " + command_of(request_, wanted_, pattern_);
  }
  named([&] {
    encoder_->finish(stop);
    if (kind_ == Film_kind::gif) make_gif(stop);
  });
  publish(folder_ / request_.file.filename(), request_.file);
  return {};
}

}  // namespace

std::unique_ptr<Film> make_video(const Film_request& request, Frame_painter paint) {
  if (const std::string reason = reason_against(request); !reason.empty()) throw File_error(request.file, 0, reason);
  check_picture_size(request.file, request.width, request.height);
  return std::make_unique<Video>(request, std::move(paint));
}

}  // namespace mesecina
