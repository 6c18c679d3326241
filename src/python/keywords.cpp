// SPDX-License-Identifier: BSD-3-Clause
#include "keywords.h"

#include <algorithm>
#include <cctype>

namespace py = pybind11;

namespace pkm_workspace
{
namespace python
{
namespace
{
using cli::Options;
using cli::Words;

bool isSequence(const py::handle& value)
{
  return PyList_Check(value.ptr()) || PyTuple_Check(value.ptr());
}

/// Lists in place of arrays and of numbers of numpy, texts in place of paths.
py::object plain(const py::handle& value)
{
  if (py::hasattr(value, "tolist"))
    return value.attr("tolist")();
  if (py::hasattr(value, "__fspath__"))
    return value.attr("__fspath__")();
  return py::reinterpret_borrow<py::object>(value);
}

/// With every digit: the number that is read is this one.
std::string wordOf(double number)
{
  char* const digits = PyOS_double_to_string(number, 'r', 0, 0, nullptr);
  const std::string word = digits;
  PyMem_Free(digits);
  return word;
}

void addWords(const py::handle& value, const Options::Kind& kind, Words& words)
{
  if (PyBool_Check(value.ptr()))
    words.push_back(value.ptr() == Py_True ? "on" : "off");
  else if (PyFloat_Check(value.ptr()))
    words.push_back(wordOf(PyFloat_AS_DOUBLE(value.ptr())));
  else if (PyLong_Check(value.ptr()))
    words.push_back(py::str(value));
  else if (PyUnicode_Check(value.ptr()))
  {
    const Words all = kind.is_list ? cli::wordsOf(py::cast<std::string>(value)) : Words{ py::cast<std::string>(value) };
    words.insert(words.end(), all.begin(), all.end());
  }
  else if (isSequence(value))
    for (const py::handle& entry : value)
      addWords(plain(entry), kind, words);
  else
    throw std::invalid_argument("a number, a text, or a list of them was expected, not a value of the type " +
                                std::string(Py_TYPE(value.ptr())->tp_name));
}

std::vector<Eigen::Vector3d> pointsOf(const py::handle& rows)
{
  std::vector<Eigen::Vector3d> points;
  for (const py::handle& row : rows)
  {
    std::vector<double> numbers;
    if (isSequence(row))
      for (const py::handle& number : row)
        numbers.push_back(py::cast<double>(number));
    if (numbers.size() != 3)
      throw std::invalid_argument("a point needs 3 numbers (X Y Z) [m]");
    points.emplace_back(numbers[0], numbers[1], numbers[2]);
  }
  return points;
}

/// Whether the entries of a value are each a value of an option that may be given several times.
bool isSeveral(const py::handle& value)
{
  if (!isSequence(value) || py::len(value) == 0)
    return false;
  return std::all_of(value.begin(), value.end(), [](const py::handle& entry) {
    return PyUnicode_Check(entry.ptr()) || isSequence(entry) || py::hasattr(entry, "__fspath__");
  });
}

void addGiven(const std::string& name, const py::object& value, const Options::Kind& kind,
              std::vector<Options::Given>& all)
{
  if (value.is_none())
    return;
  if (kind.is_repeatable && isSeveral(value))
  {
    for (const py::handle& entry : value)
    {
      all.push_back({ name, {} });
      addWords(plain(entry), kind, all.back().words);
    }
    return;
  }
  const bool is_flag = kind.values.empty() && PyBool_Check(value.ptr());
  if (is_flag && value.ptr() == Py_False)
    return;
  all.push_back({ name, {} });
  if (kind.takes_points && isSequence(value))
    all.back().points = pointsOf(value);
  else if (!is_flag)
    addWords(value, kind, all.back().words);
}
}  // namespace

std::string optionOf(std::string keyword)
{
  if (keyword.size() > 1 && keyword.back() == '_')
    keyword.pop_back();
  std::replace(keyword.begin(), keyword.end(), '_', '-');
  return keyword;
}

std::string withKeywords(const std::string& text)
{
  std::string keywords;
  for (std::size_t k = 0; k < text.size();)
  {
    const bool begins = k == 0 || !std::isalnum(static_cast<unsigned char>(text[k - 1]));
    if (!begins || text.compare(k, 2, "--") != 0 || k + 2 >= text.size() ||
        !std::islower(static_cast<unsigned char>(text[k + 2])))
    {
      keywords += text[k++];
      continue;
    }
    for (k += 2; k < text.size() && (std::isalnum(static_cast<unsigned char>(text[k])) || text[k] == '-'); ++k)
      keywords += text[k] == '-' ? '_' : text[k];
  }
  return keywords;
}

std::vector<Options::Given> givenBy(const py::dict& keywords, const Options& options)
{
  std::vector<Options::Given> all;
  Problems problems;
  for (const auto& [key, value] : keywords)
  {
    const std::string keyword = py::cast<std::string>(key);
    const std::string name = optionOf(keyword);
    const std::optional<Options::Kind> kind = options.kindOf(name);
    try
    {
      if (kind)
        addGiven(name, plain(value), *kind, all);
      else
        all.push_back({ name, {} });  // is refused with the others
    }
    catch (const std::invalid_argument& reason)
    {
      problems.push_back(keyword + ": " + reason.what());
    }
    catch (const py::cast_error&)
    {
      problems.push_back(keyword + ": numbers were expected");
    }
  }
  throwProblems(problems);
  return all;
}
}  // namespace python
}  // namespace pkm_workspace
