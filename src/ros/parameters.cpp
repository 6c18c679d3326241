// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/ros/parameters.h"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <stdexcept>

#include "parameter_values.h"
#include "pkm_workspace/dexterity/criterion_bounds.h"
#include "pkm_workspace/dexterity/criterion_text.h"
#include "pkm_workspace/dexterity/joint_data.h"
#include "pkm_workspace/interval/text_stream.h"
#include "pkm_workspace/paving/paving.h"
#include "pkm_workspace/ros/zone_message.h"

namespace pkm_workspace
{
namespace
{
using XmlRpc::XmlRpcValue;

/// XML-RPC has integers of 32 bits.
bool readMemory(const XmlRpcValue& value, std::int64_t& target)
{
  int bytes = 0;
  if (!read(value, bytes) || bytes < Budget::LEAST_MEMORY)
    return false;
  target = bytes;
  return true;
}

/// Only looks at it: the updater of diagnostics reads it by itself.
bool isPeriod(const XmlRpcValue& value)
{
  double seconds = 0.0;
  return read(value, seconds) && seconds >= 0.01 && seconds <= 3600.0;
}

struct Entry
{
  std::string expected;
  std::function<bool(const XmlRpcValue&)> set;
};
using Table = std::map<std::string, Entry>;

template <class T>
Entry entry(T& target, const std::string& expected)
{
  return { expected, [&target](const XmlRpcValue& value) { return read(value, target); } };
}

/// @param names of the enumeration, in its order
template <class Choice, std::size_t N>
Entry oneOf(Choice& target, const std::array<const char*, N>& names)
{
  std::string expected = std::string("a text: ") + names[0];
  for (std::size_t k = 1; k < N; ++k)
    expected += (k + 1 < N ? ", " : " or ") + std::string(names[k]);
  const auto set = [&target, &names](const XmlRpcValue& value) {
    std::string word;
    const auto name = read(value, word) ? std::find(names.begin(), names.end(), word) : names.end();
    if (name != names.end())
      target = static_cast<Choice>(name - names.begin());
    return name != names.end();
  };
  return { expected, set };
}

/// Zones in the frame of the root link. @throws std::invalid_argument with what is wrong
Entry zonesOf(Criterion& criterion, Zone::Use use)
{
  const auto set = [&criterion, use](const XmlRpcValue& value) {
    const std::vector<Zone> zones = readZones(use, value);
    criterion.zones.insert(criterion.zones.end(), zones.begin(), zones.end());
    return true;
  };
  return { "a list of zones", set };
}

void addTolerances(GivenTolerances& tolerances, Table& table)
{
  for (const ToleranceKind& kind : TOLERANCE_KINDS)
  {
    const auto set = [&tolerances, &kind](const XmlRpcValue& value) {
      std::vector<double> numbers(1);
      if (!read(value, numbers[0]) && !read(value, numbers))
        return false;
      tolerances.set(kind, numbers);
      return true;
    };
    table[kind.name] = { std::string("a number >= 0, or a list of three") + (kind.is_per_axis ? " or nine" : "") +
                             " [" + kind.unit + "]",
                         set };
  }
}

void addCriterion(Criterion& criterion, Table& table)
{
  for (const Zone::Use use : { Zone::Use::KEEP_IN, Zone::Use::KEEP_OUT })
    table[ZONE_USES[static_cast<std::size_t>(use)]] = zonesOf(criterion, use);
  table["tool_radius"] = entry(criterion.tool_radius, "a number >= 0 [m]");
  table["set"] = oneOf(criterion.set, SET_NAMES);
  table["aspect"] = oneOf(criterion.aspect, ASPECT_NAMES);
  table["joint_limits"] = entry(criterion.joint_limits, "true or false");
  table["hinge_limits"] = entry(criterion.hinge_limits, "true or false");
  for (const CriterionBound& bound : CRITERION_BOUNDS)
    table[bound.name] = entry(criterion.*bound.value, allowedInWords(bound));
  for (const JointDatum& datum : JOINT_DATA)
    table[datum.name] =
        entry(criterion.*datum.values, std::string("a number > 0, or a list of three [") + datum.unit + "]");
}

void addPictures(Parameters& parameters, Table& table)
{
  table["show_paving"] = entry(parameters.show_paving, "true or false");
  table["show_boundary"] = entry(parameters.show_boundary, "true or false");
  table["set_style"] = oneOf(parameters.set_style, SET_STYLE_NAMES);
  table["set_colors"] = oneOf(parameters.set_colors, SET_COLORS_NAMES);
  table["paving_resolution"] = entry(parameters.paving_resolution, "a number >= 0 [m]");
}

Table tableOf(Parameters& parameters)
{
  RegionQuery& query = parameters.query;
  Table table = {
    { "shape", entry(parameters.shape.name, "a text: cube, square, box, sphere, disc, cylinder or polytope") },
    { "proportions", entry(parameters.shape.proportions, "three numbers [x, y, z] >= 0, without unit") },
    { "ratio", entry(parameters.shape.ratio, "two numbers [least, largest] > 0, without unit") },
    { "radius", entry(parameters.shape.radius, "a number > 0 [m]") },
    { "height", entry(parameters.shape.height, "a number > 0 [m]") },
    { "footprint", entry(parameters.shape.footprint, "two numbers [x, y] > 0 [m]") },
    { "vertices", entry(parameters.shape.vertices, "a list of three numbers [x, y, z] each [m]") },
    { "turned", entry(parameters.place.turned, "true or false") },
    { "center", entry(parameters.place.center, "three numbers [x, y, z] [m]") },
    { "base_z", entry(parameters.place.base_z, "a number [m]") },
    { "accuracy", entry(parameters.accuracy, "a number >= 0 [m]") },
    { "search_box",
      entry(parameters.place.search_box, "six numbers [x0, x1, y0, y1, z0, z1], x0 <= x1 and so on [m]") },
    { "time_limit", entry(query.budget.time_limit, "a number > 0, at most 86400 [s]") },
    { "threads", entry(query.budget.threads, "a whole number >= 1") },
    { "rails", entry(parameters.urdf.rails, "a list of three names of prismatic joints or cranks, or an empty one") },
    { "tcp_links", entry(parameters.urdf.tcp_links, "a list of three names of links, or an empty one") },
    { "psi", oneOf(parameters.psi, PSI_CHOICES) },
    { "tool_link", entry(parameters.urdf.tool_link, "a text, the name of a link fixed to the platform") },
    { "tool", entry(parameters.urdf.tool, "three numbers [x, y, z] [m]") },
    { "ball_axes", entry(parameters.urdf.ball_axes, "a list of one or of three lists [x, y, z]") },
    { "publish_joint_states", entry(parameters.publish_joint_states, "true or false") },
    { "keep_out_collisions", entry(parameters.keep_out_collisions, "true or false") },
    { "max_memory",
      { "a whole number of bytes, 4096 to 2147483647",
        [&query](const XmlRpcValue& value) { return readMemory(value, query.budget.max_memory); } } },
    { "joint_acceleration_max",
      { "a number > 0, or three [m/s^2]",
        [&parameters](const XmlRpcValue& value) { return readForJoints(value, parameters.joint_acceleration_max); } } },
    { "certificate_folder", entry(parameters.certificate_folder, "a text, the name of a folder from / on") },
    { "diagnostic_period", { "a number from 0.01 to 3600 [s]", isPeriod } },
  };
  addPictures(parameters, table);
  addCriterion(query.criterion, table);
  addTolerances(parameters.urdf.tolerances, table);
  return table;
}

/// Parameters that belong to others and may be private all the same.
bool isForeign(const std::string& name)
{
  return name == "robot_description" || name == "tf_prefix";
}

void readTable(const Table& table, const XmlRpcValue& values, Problems& problems)
{
  std::string known;
  for (const auto& row : table)
    known += (known.empty() ? "" : ", ") + row.first;
  for (const auto& value : values)
  {
    const auto row = table.find(value.first);
    TextStream text;
    text << value.first << " = ";
    value.second.write(text);
    try
    {
      if (row != table.end() && !row->second.set(value.second))
        problems.push_back(text.str() + " must be " + row->second.expected);
      else if (row == table.end() && !isForeign(value.first))
        problems.push_back(text.str() + " is not a parameter of this node; these are: " + known);
    }
    catch (const std::invalid_argument& reason)
    {
      problems.push_back(value.first + ": " + reason.what());
    }
  }
}

/// Measures of a shape that is not the node's wait for a request, and are checked all the same.
void chooseRegion(const Parameters& parameters, RegionQuery& query, Problems& problems)
{
  const auto check = [&](const auto& set) {
    try
    {
      set();
    }
    catch (const std::invalid_argument& error)
    {
      problems.push_back(error.what());
    }
  };
  for (const std::string shape : { "box", "cylinder", "polytope" })
    if (const ShapeWish waiting = parameters.shape.as(shape); waiting.hasMeasures() && shape != parameters.shape.name)
      check([&] { setShape(waiting, query); });
  check([&] { setShape(parameters.shape.as(parameters.shape.name), query); });
  check([&] { setPlace(parameters.place, query); });
}

/// Bounds that are chosen by the machine leave none to give.
void choosePsi(const XmlRpcValue& values, Parameters& parameters, Problems& problems)
{
  const auto has = [&values](const char* name) {
    return values.getType() == XmlRpcValue::TypeStruct && values.hasMember(name);
  };
  parameters.default_psi = !has("psi_min") && !has("psi_max");
  if (parameters.psi == PsiChoice::AUTO &&
      (!parameters.default_psi || parameters.query.criterion.set != Criterion::Set::DEXTROUS))
    problems.push_back(
        "psi = auto chooses the bounds of a dextrous set: leave out psi_min and psi_max, and set = reachable");
}

/// Tells which of two bounds that contradict each other is a default, and leaves valid ones.
void validateBounds(const XmlRpcValue& values, Criterion& criterion, Problems& problems)
{
  const std::size_t before = problems.size();
  const Origin origin = [&values](const std::string& name) {
    return values.getType() == XmlRpcValue::TypeStruct && values.hasMember(name) ? "" : "the default";
  };
  validateCriterion(criterion, origin, problems);
  if (problems.size() == before)
    return;
  Criterion valid = defaultCriterion();
  valid.set = criterion.set;
  valid.aspect = criterion.aspect;
  criterion = valid;
}

void validateFolder(const std::string& folder, Problems& problems)
{
  if (!folder.empty() && (folder.front() != '/' || ::access((folder + "/.").c_str(), W_OK | X_OK) != 0))
    problems.push_back("certificate_folder = '" + folder +
                       "' must be a folder that exists, named from / on, in which this node may write files");
}
}  // namespace

void Parameters::validate(Problems& problems) const
{
  query.validate(problems);
  const auto complain = [&problems](const char* name, double value, const char* allowed) {
    TextStream text;
    text << name << " = " << value << " " << allowed;
    problems.push_back(text.str());
  };
  // the query allows more: 0 for no limit
  if (query.budget.time_limit == 0.0 || query.budget.time_limit > LONGEST)
    complain("time_limit", query.budget.time_limit, "s must be > 0 and at most 86400 s");
  if (!(accuracy >= 0.0 && accuracy <= 1e100))
    complain("accuracy", accuracy, "m must be positive and finite, or 0 for a thousandth of the longest strut");
  if (!(paving_resolution >= 0.0 && paving_resolution <= 1e100))
    complain("paving_resolution", paving_resolution, "m must be >= 0 and finite");
  validateFolder(certificate_folder, problems);
}

Parameters loadParameters(const ros::NodeHandle& private_node)
{
  Parameters parameters;
  Problems problems;
  XmlRpcValue values;
  if (private_node.getParam(private_node.getNamespace(), values) && values.getType() == XmlRpcValue::TypeStruct)
    readTable(tableOf(parameters), values, problems);
  chooseRegion(parameters, parameters.query, problems);
  choosePsi(values, parameters, problems);
  for (const CriterionBound& bound : CRITERION_BOUNDS)  // as in requests
    if (double& value = parameters.query.criterion.*bound.value; bound.is_optional && std::isinf(value) && value > 0.0)
      value = 0.0;
  for (const JointDatum& datum : JOINT_DATA)
    for (double& value : parameters.query.criterion.*datum.values)
      if (std::isinf(value) && value > 0.0)
        value = 0.0;
  validateBounds(values, parameters.query.criterion, problems);
  parameters.validate(problems);
  for (auto& problem : problems)
    problem = "parameter of " + private_node.getNamespace() + ": " + problem;
  throwProblems(problems);
  return parameters;
}

}  // namespace pkm_workspace
