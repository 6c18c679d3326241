// SPDX-License-Identifier: BSD-3-Clause
#include "common_options.h"

#include <algorithm>
#include <stdexcept>

#include "given_machine.h"

namespace pkm_workspace
{
namespace cli
{
namespace
{
constexpr const char* URDF_HELP = "URDF of the machine: three branches, cut at the platform";
constexpr const char* RAILS_HELP =
    "names of the three joints that drive the legs, prismatic ones or cranks; needed when the URDF has more";
constexpr const char* TCP_LINKS_HELP =
    "names of the three links, one a leg, that are the tool point; without it, the deepest that coincide";

constexpr const char* TOOL_LINK_HELP =
    "name of a link fixed to the platform that is the tool point (a spindle's tip); without it, where the legs meet";

constexpr const char* TOOL_HELP =
    "in place of --tool-link, the tool's tip seen from where the legs meet, along the axes of the root link: all "
    "answers are about the tip";
constexpr const char* BALL_AXES_HELP =
    "where ball joints are not tilted: along the strut from slider to platform, in the root frame; without it, as at "
    "joint values 0";

void assign(const Words& words, Words& target)
{
  target = words;
}

void assign(const Words& words, std::string& target)
{
  target = words[0];
}

void assign(const Words& words, std::optional<Eigen::Vector3d>& target)
{
  const std::vector<double> numbers = readNumbers(words, LENGTH);
  target = Eigen::Vector3d(numbers[0], numbers[1], numbers[2]);
}

/// Three numbers for all legs, or nine.
void assign(const Words& words, std::vector<Eigen::Vector3d>& target)
{
  const std::vector<double> numbers = readNumbers(words, Quantity());
  for (std::size_t k = 0; k < numbers.size(); k += 3)
    target.emplace_back(numbers[k], numbers[k + 1], numbers[k + 2]);
}
}  // namespace

void MachineOptions::declare(Options& options)
{
  options.text("urdf", path_, "FILE", URDF_HELP);
  options.texts("rails", names_.rails, "JOINT JOINT JOINT", RAILS_HELP);
  options.texts("tcp-links", names_.tcp_links, "LINK LINK LINK", TCP_LINKS_HELP);
  options.text("tool-link", names_.tool_link, "LINK", TOOL_LINK_HELP);
  options.vector("tool", names_.tool, "X Y Z", LENGTH, TOOL_HELP);
  options.legs("ball-axes", "X Y Z", BALL_AXES_HELP, [this](const Words& words) { assign(words, names_.ball_axes); });
  declareTolerances(options, [this]() -> ToleranceWish& { return tolerances_; });
  if (options.machines().empty())
    options.require({ "urdf" });
  options.check({ "urdf", "rails", "tcp-links", "tool-link", "tool", "ball-axes" },
                [this, &options](Problems& problems) { read(options, problems); });
}

void MachineOptions::read(const Options& options, Problems& problems)
{
  names_.tolerances = tolerances_.both();
  try
  {
    if (options.machines().empty())
      urdf_ = readUrdfFile(path_, names_);
    else if (options.machines().size() > 1 || options.given("urdf"))
      throw std::invalid_argument("the question is about one machine: give it once");
    else
      take(*options.machines()[0]);
  }
  catch (const std::invalid_argument& reason)
  {
    problems.push_back(reason.what());
  }
}

void MachineOptions::take(const GivenMachine& given)
{
  const auto orGiven = [](auto& name, const auto& before) {
    const bool is_new = name != std::decay_t<decltype(name)>();
    name = is_new ? name : before;
    return is_new;
  };
  bool is_new = !names_.tolerances.isEmpty() || !given.read;
  names_.tolerances = ToleranceWish{ names_.tolerances, given.names.tolerances }.both();
  is_new |= orGiven(names_.rails, given.names.rails);
  is_new |= orGiven(names_.tcp_links, given.names.tcp_links);
  is_new |= orGiven(names_.tool_link, given.names.tool_link);
  is_new |= orGiven(names_.tool, given.names.tool);
  is_new |= orGiven(names_.ball_axes, given.names.ball_axes);
  urdf_ = is_new ? readUrdf(given.urdf, names_) : *given.read;
}

MachinesOptions::Request& MachinesOptions::latest()
{
  if (requests_.empty())
    throw std::invalid_argument("give it after the --urdf FILE that it is about");
  return requests_.back();
}

template <class Member>
std::function<void(const Words&)> MachinesOptions::setterOf(Member member)
{
  return [this, member](const Words& words) {
    auto& names = *member(latest().names);
    if (names != std::decay_t<decltype(names)>())
      throw std::invalid_argument("given a second time for --urdf " + requests_.back().path);
    assign(words, names);
  };
}

template <class Member>
void MachinesOptions::declareNames(Options& options, const std::string& name, const std::string& values,
                                   const std::string& help, Member member)
{
  options.repeated(name, values, help + AFTER_URDF, setterOf(member));
}

void MachinesOptions::declare(Options& options)
{
  for (const GivenMachine* const given : options.machines())
    machines_.push_back(given->read.value());
  given_ = machines_.size();
  options.repeated("urdf", "FILE", URDF_HELP, [this](const Words& words) {
    requests_.push_back({ words[0], {}, {} });
  });
  declareNames(options, "rails", "JOINT JOINT JOINT", RAILS_HELP, [](UrdfOptions& all) { return &all.rails; });
  declareNames(options, "tcp-links", "LINK LINK LINK", TCP_LINKS_HELP, [](UrdfOptions& all) { return &all.tcp_links; });
  declareNames(options, "tool-link", "LINK", TOOL_LINK_HELP, [](UrdfOptions& all) { return &all.tool_link; });
  declareNames(options, "tool", "X Y Z", std::string(TOOL_HELP) + "; each " + LENGTH.describe(),
               [](UrdfOptions& all) { return &all.tool; });
  options.repeatedLegs("ball-axes", "X Y Z", std::string(BALL_AXES_HELP) + AFTER_URDF,
                       setterOf([](UrdfOptions& all) { return &all.ball_axes; }));
  options.check({}, [this](Problems& problems) {
    for (Request& request : requests_)
      try
      {
        request.names.tolerances = request.tolerances.both();
        machines_.push_back(readUrdfFile(request.path, request.names));
      }
      catch (const std::invalid_argument& reason)
      {
        problems.push_back("--urdf " + request.path + ": " + reason.what());
      }
  });
}

Words remarksOn(const UrdfMachine& urdf)
{
  Words all = urdf.warnings;
  if (!urdf.gap.empty())
    all.push_back(urdf.gap);
  return all;
}

Words MachinesOptions::warnings() const
{
  Words all;
  for (const UrdfMachine& machine : machines_)
    for (const std::string& remark : remarksOn(machine))
      all.push_back(remark);
  return all;
}
}  // namespace cli
}  // namespace pkm_workspace
