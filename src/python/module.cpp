// SPDX-License-Identifier: BSD-3-Clause
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <chrono>
#include <sstream>

#include "command.h"
#include "common_options.h"
#include "given_machine.h"
#include "keywords.h"
#include "output.h"
#include "pkm_workspace/common/whole_file.h"
#include "pkm_workspace/study/machine_family.h"
#include "pkm_workspace/urdf_io/urdf_writer.h"
#include "pkm_workspace/version.h"
#include "python_caller.h"
#include "results.h"

namespace py = pybind11;

namespace pkm_workspace
{
namespace python
{
namespace
{
using cli::GivenMachine;
using cli::Options;

/// Of a URDF.
constexpr std::size_t LARGEST_FILE = std::size_t(1) << 28;

/// Raises PkmError, with the remedy for a name that there is not.
[[noreturn]] void refuse(const std::string& reason, const std::string& command)
{
  std::string text = withKeywords(reason);
  if (text.find("there is no such option") != std::string::npos)
    text += "\nhelp(pkm_workspace." + command + ") describes what there is";
  PyErr_SetString(py::module_::import("pkm_workspace.errors").attr("PkmError").ptr(), text.c_str());
  throw py::error_already_set();
}

/// One call of a command, without what is Python.
struct Call
{
  explicit Call(const std::string& name, std::vector<const GivenMachine*> machines = {}, bool describes = false)
    : command(cli::findCommand(name).make()), options(describes, std::move(machines))
  {
    command->setCaller(caller);
    command->declare(options);
  }

  /// Parses and answers.
  cli::Answer answer(const std::vector<Options::Given>& given)
  {
    options.parse(given);
    for (const std::string& text : command->warnings())
      caller.warn(text);
    for (const std::string& text : command->notes())
      caller.note(text);
    const auto begin = std::chrono::steady_clock::now();
    cli::Answer found = withRemedy(command->remedy(), [this] { return command->answer(); });
    seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    return found;
  }

  /// @return why nothing was saved, if so
  std::string save()
  {
    try
    {
      command->save();
    }
    catch (const std::invalid_argument& reason)
    {
      return std::string("the answer is complete, but it was not saved: ") + reason.what();
    }
    catch (const cli::Failure& failure)
    {
      return failure.what();
    }
    return "";
  }

  PythonCaller caller;
  std::unique_ptr<cli::Command> command;
  Options options;
  double seconds = 0.0;  ///< that the answer took
};

/// @return the answer, what it warns of, what it notes, why its files were not saved, and how long it took [s]
py::tuple run(const std::string& name, const std::vector<const GivenMachine*>& machines, const py::dict& keywords,
              const py::object& dictionary)
{
  Call call(name, machines);
  try
  {
    const std::vector<Options::Given> given = givenBy(keywords, call.options);
    const StopsOnInterrupt stops(call.caller);
    std::optional<cli::Answer> answer;
    {
      const py::gil_scoped_release release;
      answer = call.answer(given);
    }
    const py::object object = objectOf(*answer, dictionary);
    std::string lost;
    {
      const py::gil_scoped_release release;
      lost = call.save();
    }
    return py::make_tuple(object, call.caller.warnings, call.caller.notes, withKeywords(lost), call.seconds);
  }
  catch (const std::invalid_argument& reason)
  {
    refuse(reason.what(), name);
  }
}

/// The machine that a command makes of numbers or of a firmware's configuration. @return it and the answer
py::tuple make(const std::string& name, const py::dict& keywords, const py::object& dictionary)
{
  Call call(name);
  try
  {
    const std::vector<Options::Given> given = givenBy(keywords, call.options);
    const cli::Answer answer = [&] {
      const py::gil_scoped_release release;
      return call.answer(given);
    }();
    if (!answer.json.contains("urdf") || call.command->made() == nullptr)
      throw std::invalid_argument("--output, --template: a machine is made here, no file is written");
    GivenMachine machine{ answer.json["urdf"], {}, *call.command->made() };
    return py::make_tuple(machine, objectOf(answer, dictionary), call.caller.warnings);
  }
  catch (const std::invalid_argument& reason)
  {
    refuse(reason.what(), "Machine");
  }
}

GivenMachine read(const std::string& text_or_path, const py::dict& keywords)
{
  const std::size_t first = text_or_path.find_first_not_of(" \t\r\n");
  const bool is_text = first != std::string::npos && text_or_path[first] == '<';
  try
  {
    const GivenMachine raw{ is_text ? text_or_path : readWholeFile(text_or_path, LARGEST_FILE), {}, {} };
    Options options(false, { &raw });
    cli::MachineOptions machine;
    machine.declare(options);
    options.parse(givenBy(keywords, options));
    return { raw.urdf, machine.names(), machine.urdf() };
  }
  catch (const std::invalid_argument& reason)
  {
    refuse((is_text ? "" : text_or_path + ": ") + reason.what(), "Machine");
  }
}

/// A machine of the family between two, as a URDF says it.
GivenMachine mix(const GivenMachine& first, const GivenMachine& last, double share, bool joint_limits)
{
  try
  {
    const MachineFamily family = familyBetween(first.read->machine, last.read->machine, joint_limits);
    const std::string urdf = writeUrdf(family.at(Interval(share)));
    return { urdf, {}, readUrdf(urdf) };
  }
  catch (const std::invalid_argument& reason)
  {
    refuse(reason.what(), "study.Mixture");
  }
}

/// Of each option: its name, the names of its values, what it means.
std::string describe(const std::string& name)
{
  Call call(name, {}, true);
  std::ostringstream text;
  text << cli::wrapped(call.command->description()) << "\n";
  call.options.describe(text);
  return withKeywords(text.str());
}

py::list kindsOf(const std::string& name)
{
  Call call(name);
  py::list kinds;
  for (const std::string& option : call.options.names())
  {
    const Options::Kind kind = *call.options.kindOf(option);
    kinds.append(py::make_tuple(option, kind.values, kind.is_repeatable, kind.takes_points, kind.for_each_leg));
  }
  return kinds;
}
}  // namespace

PYBIND11_MODULE(_core, module)
{
  if (const std::string distrust = rounding::selfTest(); !distrust.empty())
    throw py::import_error("the arithmetic of this computer cannot be trusted: " + distrust);
  py::class_<GivenMachine>(module, "Machine")
      .def_readonly("urdf", &GivenMachine::urdf)
      .def_property_readonly("name", [](const GivenMachine& machine) { return machine.read->machine.name(); })
      .def_property_readonly("joints",
                             [](const GivenMachine& machine) {
                               std::vector<std::string> joints;
                               for (const Leg& leg : machine.read->machine.legs())
                                 joints.push_back(leg.joint);
                               return joints;
                             })
      .def_property_readonly("warnings", [](const GivenMachine& machine) { return cli::remarksOn(*machine.read); });
  module.def("run", &run);
  module.def("make", &make);
  module.def("read", &read);
  module.def("mix", &mix);
  module.def("describe", &describe);
  module.def("kinds_of", &kindsOf);
  module.attr("__version__") = version();
}
}  // namespace python
}  // namespace pkm_workspace
