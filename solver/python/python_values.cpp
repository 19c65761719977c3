#include "solver/python/python_values.hpp"

#include <fmt/format.h>
#include <pybind11/stl.h>

#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "solver/base/error.hpp"

namespace talus::python {
namespace {

namespace py = pybind11;

std::string text_of(py::handle value) {
  return py::cast<std::string>(py::str(value).attr("encode")("utf-8", "replace").attr("decode")());
}

/// The error of a value at this path.
InputError error_at(const std::string& path, const std::string& message) {
  return InputError{path.empty() ? message : path + ": " + message};
}

/// Errors: InputError for one half of a surrogate pair, which UTF-8 cannot express.
std::string text(py::handle value, const std::string& path) {
  try {
    return py::cast<std::string>(value);
  } catch (const py::cast_error&) {
    throw error_at(path, "found a text that is not Unicode: " + text_of(value));
  }
}

}  // namespace

py::object to_python(const TomlValue& value) {
  if (const auto* text = std::get_if<std::string>(&value.data)) return py::str(*text);
  if (const auto* number = std::get_if<double>(&value.data)) return py::float_(*number);
  if (const auto* whole = std::get_if<std::int64_t>(&value.data)) return py::int_(*whole);
  if (const auto* flag = std::get_if<bool>(&value.data)) return py::bool_(*flag);
  if (const auto* array = std::get_if<TomlArray>(&value.data)) {
    py::list list;
    for (const TomlValue& element : *array)
      list.append(to_python(element));
    return list;
  }
  const auto* const table = std::get_if<TomlTable>(&value.data);
  if (table == nullptr) throw InputError{"found a date or time; no field has one"};
  py::dict dict;
  for (const TomlEntry& entry : *table)
    dict[py::str(entry.key)] = to_python(entry.value);
  return dict;
}

py::object to_python(const std::string& json) { return py::module_::import("json").attr("loads")(json); }

std::string key_of(py::handle key) {
  if (!py::isinstance<py::str>(key))
    throw InputError{fmt::format("found the key {}; it must be a text", text_of(py::repr(key)))};
  return text(key, "");
}

TomlValue to_document(py::handle value, const std::string& path, int depth) {
  // A list can contain itself.
  constexpr int maximum_depth = 100;
  if (depth > maximum_depth)
    throw InputError{fmt::format("found more than {} levels of lists and dicts in each other", maximum_depth)};
  // Scalars of numpy, and arrays without dimensions, are what they hold.
  if (py::hasattr(value, "dtype") && py::hasattr(value, "item") && py::cast<int>(value.attr("ndim")) == 0) {
    const py::object item = value.attr("item")();
    if (!item.is(value) && !py::hasattr(item, "dtype")) return to_document(item, path, depth);
  }
  TomlValue made;
  // A bool is an int of Python, and comes first.
  if (py::isinstance<py::bool_>(value)) {
    made.data = py::cast<bool>(value);
  } else if (py::isinstance<py::str>(value)) {
    made.data = text(value, path);
  } else if (py::isinstance<py::float_>(value)) {
    made.data = py::cast<double>(value);
  } else if (PyIndex_Check(value.ptr()) != 0 && !py::isinstance<py::array>(value)) {
    const auto index = py::reinterpret_steal<py::object>(PyNumber_Index(value.ptr()));
    if (!index) throw py::error_already_set{};
    try {
      made.data = py::cast<std::int64_t>(index);
    } catch (const py::cast_error&) {
      throw error_at(path, fmt::format("found {}; a whole number must have at most 63 bits", text_of(value)));
    }
  } else if (PyMapping_Check(value.ptr()) != 0 && py::hasattr(value, "items")) {
    TomlTable table;
    for (const py::handle item : value.attr("items")()) {
      const auto pair = py::cast<py::tuple>(item);
      if (pair.size() != 2) throw error_at(path, "found items that are not pairs of key and value");
      auto key = key_of(pair[0]);
      TomlValue entry = to_document(pair[1], path.empty() ? key : path + "." + key, depth + 1);
      table.push_back({std::move(key), std::move(entry)});
    }
    made.data = std::move(table);
  } else if (PySequence_Check(value.ptr()) != 0 && !py::isinstance<py::bytes>(value)) {
    TomlArray array;
    std::size_t i = 0;
    for (const py::handle element : value)
      array.push_back(to_document(element, fmt::format("{}[{}]", path, i++), depth + 1));
    made.data = std::move(array);
  } else if (py::hasattr(value, "__float__") && PyComplex_Check(value.ptr()) == 0) {
    const double number = PyFloat_AsDouble(value.ptr());
    if (PyErr_Occurred() != nullptr) throw py::error_already_set{};
    made.data = number;
  } else {
    throw error_at(path, fmt::format("found an object of type {}; it must be a text, a number, a list or a dict",
                                     text_of(py::type::of(value).attr("__name__"))));
  }
  return made;
}

py::dict to_python(const Archive& archive) {
  py::dict items;
  for (const auto& [name, item] : archive.items())
    std::visit([&, &name = name](const auto& value) { items[py::str(name)] = py::cast(value); }, item);
  return items;
}

ArchiveItems to_items(const py::dict& saved) {
  ArchiveItems items;
  for (const auto& [name, item] : saved) {
    auto& kept = items[py::cast<std::string>(name)];
    if (py::isinstance<py::str>(item)) {
      kept = py::cast<std::string>(item);
    } else {
      kept = py::cast<std::vector<double>>(item);
    }
  }
  return items;
}

py::array_t<double> view(std::span<const double> numbers, py::handle owner) {
  py::array_t<double> array{static_cast<py::ssize_t>(numbers.size()), numbers.data(), owner};
  array.attr("setflags")(py::arg("write") = false);
  return array;
}

}  // namespace talus::python
