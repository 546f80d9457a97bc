// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <map>
#include <span>
#include <string>
#include <string_view>

namespace mesecina {

/// Owners of OpenGL objects. All need the context in which they were made to be current, the destructors too.

class Gl_buffer {
 public:
  Gl_buffer() = default;
  explicit Gl_buffer(std::span<const float> data);
  ~Gl_buffer();
  Gl_buffer(Gl_buffer&& other) noexcept;
  Gl_buffer& operator=(Gl_buffer&& other) noexcept;

  unsigned id() const { return id_; }
  bool is_empty() const { return id_ == 0; }

 private:
  unsigned id_ = 0;
};

class Gl_texture {
 public:
  Gl_texture() = default;
  /// RGB bytes, read by texelFetch.
  static Gl_texture line(std::span<const std::uint8_t> rgb);
  /// RGBA bytes, rows from the top; sharp pixels when enlarged, averaged ones when reduced.
  static Gl_texture picture(int width, int height, std::span<const std::uint8_t> rgba);
  /// Longest side a picture may have.
  static int largest_side();
  ~Gl_texture();
  Gl_texture(Gl_texture&& other) noexcept;
  Gl_texture& operator=(Gl_texture&& other) noexcept;

  unsigned id() const { return id_; }

 private:
  unsigned id_ = 0;
};

/// A picture to draw into, RGBA, with one sample per pixel and no stencil.
class Gl_target {
 public:
  Gl_target(int width, int height);
  ~Gl_target();
  Gl_target(const Gl_target&) = delete;
  Gl_target& operator=(const Gl_target&) = delete;

  int width() const { return width_; }
  int height() const { return height_; }
  /// Of the framebuffer.
  unsigned id() const { return id_; }
  /// Sharp pixels.
  unsigned texture() const { return texture_; }

 private:
  int width_ = 0;
  int height_ = 0;
  unsigned id_ = 0;
  unsigned texture_ = 0;
};

/// Numbers that shaders read by their index, four or two in each entry.
class Gl_table {
 public:
  /// Entries of four whole numbers, of four floats, of two floats. None: an empty table.
  static Gl_table whole_numbers(std::span<const std::int32_t> data);
  static Gl_table quadruples(std::span<const float> data);
  static Gl_table pairs(std::span<const float> data);
  Gl_table() = default;
  ~Gl_table();
  Gl_table(Gl_table&& other) noexcept;
  Gl_table& operator=(Gl_table&& other) noexcept;

  int count() const { return count_; }  ///< entries
  std::size_t bytes() const { return bytes_; }
  /// For the sampler that reads this unit.
  void bind(int unit) const;

 private:
  Gl_table(const void* data, std::size_t bytes, int bytes_of_entry, unsigned format);

  unsigned buffer_ = 0;
  unsigned texture_ = 0;
  int count_ = 0;
  std::size_t bytes_ = 0;
};

/// A picture with a depth and a stencil to draw into, one sample per pixel; shaders can read picture and depth.
class Gl_deep_target {
 public:
  enum class Format {
    color,       ///< 8 bits of each component
    fine_color,  ///< half floats
    ids          ///< two whole numbers
  };
  Gl_deep_target(int width, int height, Format format);
  ~Gl_deep_target();
  Gl_deep_target(const Gl_deep_target&) = delete;
  Gl_deep_target& operator=(const Gl_deep_target&) = delete;

  int width() const { return width_; }
  int height() const { return height_; }
  /// To be drawn into.
  void bind() const;
  unsigned id() const { return id_; }  ///< of the framebuffer
  unsigned texture() const { return texture_; }
  unsigned depth() const { return depth_; }  ///< floats, as the comparisons see them

 private:
  int width_ = 0;
  int height_ = 0;
  unsigned id_ = 0;
  unsigned texture_ = 0;
  unsigned depth_ = 0;
};

class Gl_program {
 public:
  /// The sources are put together. Throws std::runtime_error with the compiler's message.
  Gl_program(std::initializer_list<std::string_view> vertex, std::initializer_list<std::string_view> fragment);
  ~Gl_program();
  Gl_program(Gl_program&& other) noexcept;
  Gl_program& operator=(Gl_program&&) = delete;

  void use() const;
  /// Of the program in use. A name that no shader reads is ignored.
  void set(std::string_view name, bool value);
  void set(std::string_view name, int value);
  void set(std::string_view name, float value);
  void set(std::string_view name, std::array<float, 2> value);
  void set(std::string_view name, std::array<float, 3> value);
  void set(std::string_view name, std::array<float, 4> value);
  /// A matrix of four columns.
  void set_matrix(std::string_view name, const float* columns);

 private:
  int location(std::string_view name);

  unsigned id_ = 0;
  std::map<std::string, int, std::less<>> locations_;
};

}  // namespace mesecina
