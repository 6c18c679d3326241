// SPDX-License-Identifier: BSD-3-Clause
#include "results.h"

#include <pybind11/numpy.h>

namespace py = pybind11;

namespace pkm_workspace
{
namespace python
{
namespace
{
using nlohmann::json;

/// @param make computes without the interpreter
template <class Make>
auto unlocked(const Make& make)
{
  const py::gil_scoped_release release;
  return make();
}

py::object arrayOf(const std::vector<Box>& boxes)
{
  py::array_t<double> array({ boxes.size(), std::size_t(3), std::size_t(2) });
  double* number = array.mutable_data();
  for (const Box& box : boxes)
    for (int axis = 0; axis < 3; ++axis)
    {
      *number++ = box.lower[axis];
      *number++ = box.upper[axis];
    }
  return array;
}

py::object objectOf(const cli::LongList& list, const py::object& dictionary)
{
  const std::vector<json> entries = unlocked([&list] {
    std::vector<json> all;
    while (list.goes_on())
      all.push_back(list.next());
    return all;
  });
  py::list objects(entries.size());
  for (std::size_t k = 0; k < entries.size(); ++k)
    objects[k] = python::objectOf(entries[k], dictionary);
  return objects;
}

py::object objectOf(const cli::BoxLists& lists, const py::object& dictionary)
{
  const py::object objects = dictionary();
  for (const auto& [name, make] : lists)
    objects[py::str(name)] = arrayOf(unlocked(make));
  return objects;
}

py::object objectOf(const std::function<json()>& make, const py::object& dictionary)
{
  return python::objectOf(unlocked(make), dictionary);
}
}  // namespace

py::object objectOf(const json& value, const py::object& dictionary)
{
  switch (value.type())
  {
    case json::value_t::object:
    {
      const py::object object = dictionary();
      for (const auto& [key, member] : value.items())
        if (PyDict_SetItem(object.ptr(), py::str(key).ptr(), objectOf(member, dictionary).ptr()) != 0)
          throw py::error_already_set();
      return object;
    }
    case json::value_t::array:
    {
      py::list list(value.size());
      for (std::size_t k = 0; k < value.size(); ++k)
        list[k] = objectOf(value[k], dictionary);
      return list;
    }
    case json::value_t::string:
      return py::reinterpret_steal<py::object>(
          PyUnicode_DecodeUTF8(value.get_ref<const std::string&>().data(),
                               static_cast<Py_ssize_t>(value.get_ref<const std::string&>().size()), "replace"));
    case json::value_t::boolean:
      return py::bool_(value.get<bool>());
    case json::value_t::number_integer:
    case json::value_t::number_unsigned:
      return py::int_(value.get<std::int64_t>());
    case json::value_t::number_float:
      return py::float_(value.get<double>());
    default:
      return py::none();
  }
}

py::object objectOf(const cli::Answer& answer, const py::object& dictionary)
{
  const py::object object = objectOf(answer.json, dictionary);
  for (const auto& [name, member] : answer.long_members)
    object[py::str(name)] = std::visit([&](const auto& known) { return objectOf(known, dictionary); }, member);
  return object;
}
}  // namespace python
}  // namespace pkm_workspace
