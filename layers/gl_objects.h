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
  void set(std::string_view name, std::array<float, 4> value);

 private:
  int location(std::string_view name);

  unsigned id_ = 0;
  std::map<std::string, int, std::less<>> locations_;
};

}  // namespace mesecina
