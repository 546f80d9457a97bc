// SPDX-License-Identifier: GPL-3.0-or-later
#include "layers/gl_objects.h"

#include <epoxy/gl.h>

#include <stdexcept>
#include <utility>
#include <vector>

namespace mesecina {

namespace {

unsigned compile(unsigned type, std::initializer_list<std::string_view> sources) {
  std::vector<const char*> texts;
  std::vector<int> lengths;
  for (std::string_view source : sources) {
    texts.push_back(source.data());
    lengths.push_back(static_cast<int>(source.size()));
  }
  const unsigned shader = glCreateShader(type);
  glShaderSource(shader, static_cast<int>(texts.size()), texts.data(), lengths.data());
  glCompileShader(shader);
  int compiled = 0;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
  if (!compiled) {
    std::string log(4096, '\0');
    int length = 0;
    glGetShaderInfoLog(shader, static_cast<int>(log.size()), &length, log.data());
    log.resize(static_cast<std::size_t>(length));
    glDeleteShader(shader);
    throw std::runtime_error("a shader does not compile: " + log);
  }
  return shader;
}

}  // namespace

Gl_buffer::Gl_buffer(std::span<const float> data) {
  glGenBuffers(1, &id_);
  glBindBuffer(GL_ARRAY_BUFFER, id_);
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(data.size_bytes()), data.data(), GL_STATIC_DRAW);
}

Gl_buffer::~Gl_buffer() {
  if (id_) glDeleteBuffers(1, &id_);
}

Gl_buffer::Gl_buffer(Gl_buffer&& other) noexcept : id_(std::exchange(other.id_, 0)) {}

Gl_buffer& Gl_buffer::operator=(Gl_buffer&& other) noexcept {
  std::swap(id_, other.id_);
  return *this;
}

Gl_texture Gl_texture::line(std::span<const std::uint8_t> rgb) {
  Gl_texture texture;
  glGenTextures(1, &texture.id_);
  glBindTexture(GL_TEXTURE_1D, texture.id_);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glTexImage1D(GL_TEXTURE_1D, 0, GL_RGB8, static_cast<int>(rgb.size() / 3), 0, GL_RGB, GL_UNSIGNED_BYTE, rgb.data());
  glTexParameteri(GL_TEXTURE_1D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_1D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  return texture;
}

Gl_texture Gl_texture::picture(int width, int height, std::span<const std::uint8_t> rgba) {
  Gl_texture texture;
  glGenTextures(1, &texture.id_);
  glBindTexture(GL_TEXTURE_2D, texture.id_);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, rgba.data());
  glGenerateMipmap(GL_TEXTURE_2D);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  return texture;
}

int Gl_texture::largest_side() {
  int side = 0;
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &side);
  return side;
}

Gl_texture::~Gl_texture() {
  if (id_) glDeleteTextures(1, &id_);
}

Gl_texture::Gl_texture(Gl_texture&& other) noexcept : id_(std::exchange(other.id_, 0)) {}

Gl_texture& Gl_texture::operator=(Gl_texture&& other) noexcept {
  std::swap(id_, other.id_);
  return *this;
}

Gl_target::Gl_target(int width, int height) : width_(width), height_(height) {
  glGenTextures(1, &texture_);
  glBindTexture(GL_TEXTURE_2D, texture_);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  int shown = 0;
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &shown);
  glGenFramebuffers(1, &id_);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, id_);
  glFramebufferTexture2D(GL_DRAW_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture_, 0);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, static_cast<unsigned>(shown));
}

Gl_target::~Gl_target() {
  glDeleteFramebuffers(1, &id_);
  glDeleteTextures(1, &texture_);
}

Gl_table::Gl_table(const void* data, std::size_t bytes, int bytes_of_entry, unsigned format)
    : count_(static_cast<int>(bytes / static_cast<std::size_t>(bytes_of_entry))), bytes_(bytes) {
  int largest = 0;
  glGetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &largest);
  if (count_ > largest)
    throw std::runtime_error("a layer has " + std::to_string(count_) + " entries, this OpenGL takes at most " +
                             std::to_string(largest));
  glGenBuffers(1, &buffer_);
  glBindBuffer(GL_TEXTURE_BUFFER, buffer_);
  glBufferData(GL_TEXTURE_BUFFER, static_cast<GLsizeiptr>(bytes), data, GL_STATIC_DRAW);
  glGenTextures(1, &texture_);
  glBindTexture(GL_TEXTURE_BUFFER, texture_);
  glTexBuffer(GL_TEXTURE_BUFFER, format, buffer_);
  glBindTexture(GL_TEXTURE_BUFFER, 0);
  glBindBuffer(GL_TEXTURE_BUFFER, 0);
}

Gl_table Gl_table::whole_numbers(std::span<const std::int32_t> data) {
  return {data.data(), data.size_bytes(), 4 * sizeof(std::int32_t), GL_RGBA32I};
}

Gl_table Gl_table::quadruples(std::span<const float> data) {
  return {data.data(), data.size_bytes(), 4 * sizeof(float), GL_RGBA32F};
}

Gl_table Gl_table::pairs(std::span<const float> data) {
  return {data.data(), data.size_bytes(), 2 * sizeof(float), GL_RG32F};
}

Gl_table::~Gl_table() {
  if (texture_) glDeleteTextures(1, &texture_);
  if (buffer_) glDeleteBuffers(1, &buffer_);
}

Gl_table::Gl_table(Gl_table&& other) noexcept
    : buffer_(std::exchange(other.buffer_, 0)),
      texture_(std::exchange(other.texture_, 0)),
      count_(other.count_),
      bytes_(other.bytes_) {}

Gl_table& Gl_table::operator=(Gl_table&& other) noexcept {
  std::swap(buffer_, other.buffer_);
  std::swap(texture_, other.texture_);
  std::swap(count_, other.count_);
  std::swap(bytes_, other.bytes_);
  return *this;
}

void Gl_table::bind(int unit) const {
  glActiveTexture(GL_TEXTURE0 + static_cast<unsigned>(unit));
  glBindTexture(GL_TEXTURE_BUFFER, texture_);
  glActiveTexture(GL_TEXTURE0);
}

Gl_deep_target::Gl_deep_target(int width, int height, Format format) : width_(width), height_(height) {
  const auto make = [&](unsigned internal, unsigned components, unsigned type) {
    unsigned texture = 0;
    glGenTextures(1, &texture);
    glBindTexture(GL_TEXTURE_2D, texture);
    glTexImage2D(GL_TEXTURE_2D, 0, static_cast<int>(internal), width, height, 0, components, type, nullptr);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    return texture;
  };
  switch (format) {
    case Format::color:
      texture_ = make(GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE);
      break;
    case Format::fine_color:
      texture_ = make(GL_RGBA16F, GL_RGBA, GL_FLOAT);
      break;
    case Format::ids:
      texture_ = make(GL_RG32UI, GL_RG_INTEGER, GL_UNSIGNED_INT);
      break;
  }
  depth_ = make(GL_DEPTH32F_STENCIL8, GL_DEPTH_STENCIL, GL_FLOAT_32_UNSIGNED_INT_24_8_REV);
  glBindTexture(GL_TEXTURE_2D, 0);
  int shown = 0;
  glGetIntegerv(GL_FRAMEBUFFER_BINDING, &shown);
  glGenFramebuffers(1, &id_);
  glBindFramebuffer(GL_FRAMEBUFFER, id_);
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture_, 0);
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, GL_TEXTURE_2D, depth_, 0);
  const bool is_complete = glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
  glBindFramebuffer(GL_FRAMEBUFFER, static_cast<unsigned>(shown));
  if (!is_complete) {
    glDeleteFramebuffers(1, &id_);
    glDeleteTextures(1, &texture_);
    glDeleteTextures(1, &depth_);
    throw std::runtime_error("OpenGL makes no picture of " + std::to_string(width) + " x " + std::to_string(height) +
                             " pixels with a depth");
  }
}

Gl_deep_target::~Gl_deep_target() {
  glDeleteFramebuffers(1, &id_);
  glDeleteTextures(1, &texture_);
  glDeleteTextures(1, &depth_);
}

void Gl_deep_target::bind() const {
  glBindFramebuffer(GL_FRAMEBUFFER, id_);
  glViewport(0, 0, width_, height_);
}

Gl_program::Gl_program(std::initializer_list<std::string_view> vertex,
                       std::initializer_list<std::string_view> fragment) {
  const unsigned vertex_shader = compile(GL_VERTEX_SHADER, vertex);
  const unsigned fragment_shader = compile(GL_FRAGMENT_SHADER, fragment);
  id_ = glCreateProgram();
  glAttachShader(id_, vertex_shader);
  glAttachShader(id_, fragment_shader);
  glLinkProgram(id_);
  glDeleteShader(vertex_shader);
  glDeleteShader(fragment_shader);
  int linked = 0;
  glGetProgramiv(id_, GL_LINK_STATUS, &linked);
  if (!linked) {
    std::string log(4096, '\0');
    int length = 0;
    glGetProgramInfoLog(id_, static_cast<int>(log.size()), &length, log.data());
    log.resize(static_cast<std::size_t>(length));
    glDeleteProgram(id_);
    throw std::runtime_error("a shader program does not link: " + log);
  }
}

Gl_program::~Gl_program() {
  if (id_) glDeleteProgram(id_);
}

Gl_program::Gl_program(Gl_program&& other) noexcept
    : id_(std::exchange(other.id_, 0)), locations_(std::move(other.locations_)) {}

void Gl_program::use() const { glUseProgram(id_); }

int Gl_program::location(std::string_view name) {
  const auto known = locations_.find(name);
  if (known != locations_.end()) return known->second;
  std::string text(name);
  const int found = glGetUniformLocation(id_, text.c_str());
  locations_.emplace(std::move(text), found);
  return found;
}

void Gl_program::set(std::string_view name, bool value) { glUniform1i(location(name), value); }
void Gl_program::set(std::string_view name, int value) { glUniform1i(location(name), value); }
void Gl_program::set(std::string_view name, float value) { glUniform1f(location(name), value); }
void Gl_program::set(std::string_view name, std::array<float, 2> value) {
  glUniform2fv(location(name), 1, value.data());
}
void Gl_program::set(std::string_view name, std::array<float, 3> value) {
  glUniform3fv(location(name), 1, value.data());
}
void Gl_program::set_matrix(std::string_view name, const float* columns) {
  glUniformMatrix4fv(location(name), 1, GL_FALSE, columns);
}
void Gl_program::set(std::string_view name, std::array<float, 4> value) {
  glUniform4fv(location(name), 1, value.data());
}

}  // namespace mesecina
