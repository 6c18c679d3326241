// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pybind11/pybind11.h>

#include "command.h"

namespace pkm_workspace
{
namespace python
{
/// What an object of JSON is, made of dictionaries of the class @p dictionary, lists, texts, numbers, booleans and
/// None.
pybind11::object objectOf(const nlohmann::json& json, const pybind11::object& dictionary);

/// All of an answer but its text. Lists of boxes are arrays of the shape (n, 3, 2): least and largest x, y, z [m].
/// @pre the interpreter is locked; it is not while long members are computed
pybind11::object objectOf(const cli::Answer& answer, const pybind11::object& dictionary);
}  // namespace python
}  // namespace pkm_workspace
