// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/input_json.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <utility>

#include "core/formats/number.h"
#include "core/formats/packed_bytes.h"
#include "core/formats/text_file.h"

namespace mesecina {

namespace {

using Json = nlohmann::json;

constexpr int widest_image = 65536;

std::string describe_json(const Json& json) {
  if (json.is_array()) return "a list of " + std::to_string(json.size());
  if (json.is_object()) return "an object";
  return quote(json.dump(-1, ' ', true, Json::error_handler_t::replace));
}

[[noreturn]] void refuse(const std::string& where, const std::string& expected, const std::string& found) {
  throw std::invalid_argument(where + ": expected " + expected + ", found " + found);
}

const Json& member(const Json& json, const std::string& where, const char* name) {
  if (!json.is_object()) refuse(where, "an object with \"" + std::string(name) + "\"", describe_json(json));
  const auto found = json.find(name);
  if (found == json.end()) refuse(where, "\"" + std::string(name) + "\"", "none");
  return *found;
}

double number_of(const Json& json, const std::string& where) {
  if (json.is_number()) return json.get<double>();
  if (json.is_string())
    if (const auto number = parse_number(json.get_ref<const std::string&>()); number && !std::isfinite(*number))
      return *number;
  if (json == "nan") return std::numeric_limits<double>::quiet_NaN();
  refuse(where, "a number", describe_json(json));
}

int integer_of(const Json& json, const std::string& where, int minimum, int maximum) {
  const bool is_good = json.is_number_integer() && json.get<std::int64_t>() >= minimum &&
                       json.get<std::int64_t>() <= maximum && !(json.is_number_unsigned() && json > maximum);
  if (!is_good)
    refuse(where, "a whole number from " + std::to_string(minimum) + " to " + std::to_string(maximum),
           describe_json(json));
  return json.get<int>();
}

void append_json_number(std::string& text, double value) {
  if (!std::isfinite(value)) {
    text += '"' + format_number(value) + '"';
  } else if (value == 0 && std::signbit(value)) {
    // Without a point it would read back as the integer 0.
    text += "-0.0";
  } else {
    append_number(text, value);
  }
}

/// Number i of an element, and how many there are.
template <class T>
struct Parts;
template <>
struct Parts<Point_2> {
  static constexpr std::size_t count = 2;
  static auto tie(auto& p) { return std::array{&p.x, &p.y}; }
};
template <>
struct Parts<Point_3> {
  static constexpr std::size_t count = 3;
  static auto tie(auto& p) { return std::array{&p.x, &p.y, &p.z}; }
};
template <>
struct Parts<Disk_2> {
  static constexpr std::size_t count = 3;
  static auto tie(auto& d) { return std::array{&d.center.x, &d.center.y, &d.radius}; }
};
template <>
struct Parts<Ball_3> {
  static constexpr std::size_t count = 4;
  static auto tie(auto& b) { return std::array{&b.center.x, &b.center.y, &b.center.z, &b.radius}; }
};

template <class T>
void write(std::string& text, const std::vector<T>& elements) {
  text += '[';
  for (std::size_t i = 0; i < elements.size(); ++i) {
    text += i == 0 ? "\n" : ",\n";
    const auto parts = Parts<T>::tie(elements[i]);
    for (std::size_t k = 0; k < parts.size(); ++k) {
      if (k > 0) text += ',';
      append_json_number(text, *parts[k]);
    }
  }
  text += ']';
}

template <class T>
void read(std::vector<T>& elements, const Json& json, const std::string& where) {
  constexpr std::size_t count = Parts<T>::count;
  if (!json.is_array() || json.size() % count != 0)
    refuse(where, "a list of numbers, " + std::to_string(count) + " per element", describe_json(json));
  elements.resize(json.size() / count);
  for (std::size_t i = 0; i < elements.size(); ++i) {
    const auto parts = Parts<T>::tie(elements[i]);
    for (std::size_t k = 0; k < count; ++k)
      *parts[k] = number_of(json[count * i + k], where + "[" + std::to_string(count * i + k) + "]");
  }
}

void write(std::string& text, const Outline_2& outline) {
  text += '[';
  for (std::size_t i = 0; i < outline.rings.size(); ++i) {
    text += i == 0 ? "\n" : ",\n";
    write(text, outline.rings[i]);
  }
  text += ']';
}

void read(Outline_2& outline, const Json& json, const std::string& where) {
  if (!json.is_array()) refuse(where, "a list of rings", describe_json(json));
  outline.rings.resize(json.size());
  for (std::size_t i = 0; i < json.size(); ++i) read(outline.rings[i], json[i], where + "[" + std::to_string(i) + "]");
}

void write(std::string& text, const Triangle_mesh_3& mesh) {
  text += "{\"vertices\":";
  write(text, mesh.vertices);
  text += ",\n\"triangles\":[";
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    text += i == 0 ? "\n" : ",\n";
    for (std::size_t k = 0; k < 3; ++k) text += (k > 0 ? "," : "") + std::to_string(mesh.triangles[i][k]);
  }
  text += "]}";
}

void read(Triangle_mesh_3& mesh, const Json& json, const std::string& where) {
  read(mesh.vertices, member(json, where, "vertices"), where + ".vertices");
  const Json& triangles = member(json, where, "triangles");
  if (!triangles.is_array() || triangles.size() % 3 != 0)
    refuse(where + ".triangles", "a list of vertex numbers, 3 per triangle", describe_json(triangles));
  mesh.triangles.resize(triangles.size() / 3);
  const int last = static_cast<int>(mesh.vertices.size()) - 1;
  for (std::size_t i = 0; i < triangles.size(); ++i)
    mesh.triangles[i / 3][i % 3] = integer_of(triangles[i], where + ".triangles[" + std::to_string(i) + "]", 0, last);
}

void write(std::string& text, const Image& image) {
  text += "{\"width\":" + std::to_string(image.width) + ",\"height\":" + std::to_string(image.height);
  text += ",\"lower-left\":[";
  append_json_number(text, image.lower_left.x);
  text += ',';
  append_json_number(text, image.lower_left.y);
  text += "],\"pixel-size\":";
  append_json_number(text, image.pixel_size);
  text += ",\n\"rgba\":\"";
  text += to_base64(deflated({reinterpret_cast<const char*>(image.rgba.data()), image.rgba.size()}));
  text += "\"}";
}

void read(Image& image, const Json& json, const std::string& where) {
  image.width = integer_of(member(json, where, "width"), where + ".width", 0, widest_image);
  image.height = integer_of(member(json, where, "height"), where + ".height", 0, widest_image);
  std::vector<Point_2> corner;
  read(corner, member(json, where, "lower-left"), where + ".lower-left");
  if (corner.size() != 1) refuse(where + ".lower-left", "two numbers", std::to_string(2 * corner.size()));
  image.lower_left = corner.front();
  image.pixel_size = number_of(member(json, where, "pixel-size"), where + ".pixel-size");
  const Json& packed = member(json, where, "rgba");
  if (!packed.is_string()) refuse(where + ".rgba", "a text in base 64", describe_json(packed));
  const std::size_t size =
      std::size_t{4} * static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
  try {
    const std::string bytes = inflated(from_base64(packed.get_ref<const std::string&>()), size);
    if (bytes.size() != size)
      throw std::invalid_argument("expected " + std::to_string(size) + " bytes for " + std::to_string(image.width) +
                                  " x " + std::to_string(image.height) + " pixels, found " +
                                  std::to_string(bytes.size()));
    image.rgba.assign(bytes.begin(), bytes.end());
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(where + ".rgba: " + error.what());
  }
}

/// How inputs of one type are written and read.
struct Form {
  std::string_view id;  ///< of the input of core/inputs.h that has this type
  std::function<bool(const Inputs&, std::string_view id)> holds;
  std::function<void(std::string&, const Inputs&, std::string_view id)> write;
  std::function<Inputs(const Inputs&, std::string_view id, const Json&, const std::string& where)> read;
  std::function<Inputs(const Inputs&, std::string_view id, const Inputs& source)> copy;
};

template <class T>
Form form_of(Input_key<T> key) {
  return {
      key.id, [](const Inputs& inputs, std::string_view id) { return inputs.get(Input_key<T>{id}) != nullptr; },
      [](std::string& text, const Inputs& inputs, std::string_view id) { write(text, *inputs.get(Input_key<T>{id})); },
      [](const Inputs& inputs, std::string_view id, const Json& json, const std::string& where) {
        T value;
        read(value, json, where);
        return inputs.with(Input_key<T>{id}, std::move(value));
      },
      [](const Inputs& inputs, std::string_view id, const Inputs& source) {
        return inputs.with(Input_key<T>{id}, source.get(Input_key<T>{id}));
      }};
}

/// One for each type of core/inputs.h; where ids have the same type, the first counts.
const std::vector<Form>& forms() {
  static const std::vector<Form> all = {form_of(points_input), form_of(disks_input), form_of(outline_input),
                                        form_of(image_input),  form_of(mesh_input),  form_of(balls_input),
                                        form_of(cloud_input)};
  return all;
}

/// Null where there is none.
const Form* form_named(std::string_view id) {
  const auto it = std::ranges::find(forms(), id, &Form::id);
  return it == forms().end() ? nullptr : &*it;
}

/// Null where there is none.
const Form* form_for(const Inputs& inputs, std::string_view id) {
  const auto it = std::ranges::find_if(forms(), [&](const Form& form) { return form.holds(inputs, id); });
  return it == forms().end() ? nullptr : &*it;
}

const Form& needed_form(const Inputs& inputs, std::string_view id) {
  if (const Form* form = form_for(inputs, id)) return *form;
  throw std::invalid_argument("the input '" + std::string(id) + "' is of a type that has no form in JSON");
}

/// Of JSON under this id, and where in it the value is; null where that is not known.
std::pair<const Form*, const Json*> form_in(std::string_view id, const Json& json) {
  if (const Form* form = form_named(id)) return {form, &json};
  const bool has_type = json.is_object() && json.contains("type") && json["type"].is_string() && json.contains("value");
  const Form* form = has_type ? form_named(json["type"].get_ref<const std::string&>()) : nullptr;
  return {form, form ? &json["value"] : nullptr};
}

}  // namespace

bool has_input_json(const Inputs& inputs, std::string_view id) { return form_for(inputs, id) != nullptr; }

void append_input_json(std::string& text, const Inputs& inputs, std::string_view id) {
  const Form& form = needed_form(inputs, id);
  if (form.id == id) {
    form.write(text, inputs, id);
    return;
  }
  text += "{\"type\": \"" + std::string(form.id) + "\", \"value\": ";
  form.write(text, inputs, id);
  text += '}';
}

Inputs with_input_of(const Inputs& inputs, std::string_view id, const Inputs& source) {
  return needed_form(source, id).copy(inputs, id, source);
}

bool is_input_json(std::string_view id, const Json& json) { return form_in(id, json).first != nullptr; }

Inputs with_input_json(const Inputs& inputs, std::string_view id, const Json& json) {
  const auto [form, value] = form_in(id, json);
  if (!form) refuse("inputs." + std::string(id), "an input of a known type", describe_json(json));
  return form->read(inputs, id, *value, "inputs." + std::string(id));
}

}  // namespace mesecina
