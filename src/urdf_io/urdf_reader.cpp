// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/urdf_io/urdf_reader.h"

#include <algorithm>
#include <cmath>

#include "closure.h"
#include "drawn_rails.h"
#include "leg_maker.h"
#include "number_text.h"
#include "pkm_workspace/common/whole_file.h"
#include "pkm_workspace/interval/decimal.h"
#include "pkm_workspace/machine/assembly.h"
#include "reader_warnings.h"
#include "refusal.h"
#include "still_collisions.h"

namespace pkm_workspace
{
using namespace urdf_io;

namespace
{
using Rails = std::array<Rail, 3>;
using ClosedLegs = std::array<ClosedLeg, 3>;

/// What is drawn this near to assembled at zero is so but for rounding [L].
constexpr double DRAWN_ASSEMBLED = 1e-9;

std::string strutLink(const ClosedLeg& leg)
{
  return leg.tcp.at_slider.back().child_link;
}

void checkBallAxes(const BallAxes& axes)
{
  Problems problems;
  validateBallAxes(axes, problems);
  throwRefusal(problems);
}

/// The zero configuration has to show the working mode and the aspect beyond doubt.
void checkSingularities(const Rails& rails, const ClosedLegs& legs, Problems& problems)
{
  const double least = urdf_tolerance::SINGULARITY;
  Interval volume = 1.0;
  for (std::size_t i = 0; i < 3; ++i)
  {
    const Interval eta = driveAtZero(rails[i], legs[i]);
    const Interval length = legs[i].geometry.length;
    volume = volume * length;
    if (!(eta.mignitude() > least * length.upper()))
      complain(problems, "link '", strutLink(legs[i]), "': a strut across ",
               rails[i].form == LegForm::CRANK ? "the way of its crank '" : "its rail '", rails[i].joint->name,
               "' at zero (serial singularity): eta = ", roundedText(eta.mid(), 6), " m, expected more than ",
               roundedText(least, 3), " L = ", roundedText(least * length.upper(), 6), " m in size");
  }
  const Interval det_a =
      determinant(strutOf(rails[0], legs[0]), strutOf(rails[1], legs[1]), strutOf(rails[2], legs[2]));
  if (!(det_a.mignitude() > least * volume.upper()))
    complain(problems, "links '", strutLink(legs[0]), "', '", strutLink(legs[1]), "', '", strutLink(legs[2]),
             "': struts in parallel planes at zero (parallel singularity): det A = ", roundedText(det_a.mid(), 6),
             " m^3, expected more than ", roundedText(least, 3),
             " L_1 L_2 L_3 = ", roundedText(least * volume.upper(), 6), " m^3 in size");
}

/// A double near the tool point as the first leg is drawn: rounding is no coordinate.
Eigen::Vector3d drawnZero(const Closure& closure)
{
  const double rounding = 1e-12 * closure.scale();
  const IntervalVector zero = closure.legs[0].tool_point + closure.tool;
  return mid(zero).unaryExpr([rounding](double x) { return std::abs(x) < rounding ? 0.0 : x; });
}

/// Where the struts meet at joint values 0, when that is where they are drawn, and the other place far away.
std::optional<Eigen::Vector3d> assembledZero(const Machine& drawn, const Closure& closure)
{
  const auto zero = assemble(drawn, Eigen::Vector3d::Zero(), drawn.aspect());
  const auto both = assemblies(drawn, Eigen::Vector3d::Zero());
  const auto distance = [&drawn](const Eigen::Vector3d& p) { return (p - drawn.zero()).norm(); };
  const bool is_clear = zero && both && distance(*zero) <= closure.allowed &&
                        std::max(distance((*both)[0]), distance((*both)[1])) > 2.0 * closure.allowed;
  return is_clear ? zero : std::nullopt;
}

Machine machineAt(const Eigen::Vector3d& zero, const std::string& name, const Machine::Legs& legs)
{
  Problems problems;
  try
  {
    return Machine(name, legs, zero);
  }
  catch (const std::invalid_argument& exception)
  {
    complain(problems, exception.what());
    throwRefusal(problems);
    throw;
  }
}

Machine makeMachine(const Model& model, const Rails& rails, const Closure& closure, const UrdfOptions& options)
{
  Problems problems;
  checkSingularities(rails, closure.legs, problems);
  const Tolerances tolerances = options.tolerances.over(tolerancesOf(
      model.document.tolerances, { rails[0].joint->name, rails[1].joint->name, rails[2].joint->name }, problems));
  throwRefusal(problems);
  Machine::Legs legs;
  for (std::size_t i = 0; i < 3; ++i)
  {
    legs[i] = machineLeg(model, rails[i], closure.legs[i], closure.tool, problems);
    setTolerance(tolerances[i], legs[i]);
  }
  throwRefusal(problems);
  setBallAxes(options.ball_axes, legs);
  const Machine drawn = machineAt(drawnZero(closure), model.tree->getName(), legs);
  if (closure.gap <= DRAWN_ASSEMBLED * closure.scale())
    return drawn;
  if (const auto zero = assembledZero(drawn, closure))
    return machineAt(*zero, drawn.name(), legs);
  if (!closure.isDrawnAssembled())
    complain(problems, "the tcp frames of links ", tcpNames(closure), " are ", roundedText(closure.gap, 6),
             " m apart at zero, and the struts do not meet within ", roundedText(closure.allowed, 6),
             " m of where they are drawn in one place alone; expected a machine that is drawn assembled at joint "
             "values 0");
  throwRefusal(problems);
  return drawn;
}

std::string inWords(const Eigen::Vector3d& tool)
{
  return "(" + exact(tool.x()) + ", " + exact(tool.y()) + ", " + exact(tool.z()) + ") m";
}

/// There is one tool point, at an ordinary place.
void checkTool(const UrdfOptions& options)
{
  Problems problems;
  if (options.tool && !options.tool_link.empty())
    complain(problems, "tool = ", inWords(*options.tool), " and tool_link = '", options.tool_link,
             "' both tell the tool point; give one of them");
  if (options.tool && !(options.tool->allFinite() && options.tool->cwiseAbs().maxCoeff() <= 1e9))
    complain(problems, "tool = ", inWords(*options.tool), " must be finite, within 1e9 m");
  throwProblems(problems);
}

/// Which link is the tool point, and why.
std::string toolPointOf(const Closure& closure, const UrdfOptions& options)
{
  std::string text = "the tool point is ";
  if (!closure.named.empty())
    text += "the link '" + closure.named + "', as tool_link names it; the legs meet where the links ";
  else if (options.tool)
    text += inWords(*options.tool) + " from where the legs meet, as tool gives it; they meet where the links ";
  else
    text += "where the links ";
  text += tcpNames(closure) + " coincide at joint values 0" +
          (options.tcp_links.empty() ? ", the deepest that do" : ", as tcp_links names them");
  return text;
}

/// How the loops close that are not drawn closed.
std::string gapOf(const Closure& closure, const Machine& machine)
{
  if (closure.gap <= DRAWN_ASSEMBLED * closure.scale())
    return "";
  const bool is_drawn = machine.zero() == drawnZero(closure);
  return "the legs are drawn up to " + significantAbove(closure.gap, 3) +
         " m apart at joint values 0 (allowed: " + roundedText(closure.allowed, 3) + " m); the zero configuration is " +
         (is_drawn ? "as the first leg is drawn" : "where the struts meet");
}

StrutHinges hingesOf(const Rail& rail, const ClosedLeg& leg)
{
  const auto& hinges = leg.tcp.at_slider;
  const HingePair pair = bestPair(hinges, leg.geometry.strut);
  const auto& first = hinges[pair.first];
  const auto& second = hinges[pair.second];
  const auto axis = [&rail](const Hinge& hinge) { return mid(rail.slider.rotation * hinge.axis.enclosure); };
  return { { first.joint, second.joint },
           { first.master, second.master },
           { first.factor, second.factor },
           { axis(first).normalized(), axis(second).normalized() },
           mid(strutOf(rail, leg)) };
}

/// All that follows from the rails and from the passive joints at the sliders.
std::vector<JointFollower> followersIn(const Model& model, const Rails& rails, const ClosedLegs& legs)
{
  std::vector<std::string> masters;
  for (std::size_t i = 0; i < 3; ++i)
  {
    masters.push_back(rails[i].joint->name);
    for (const Hinge& hinge : legs[i].tcp.at_slider)
      masters.push_back(hinge.master);
  }
  std::vector<JointFollower> followers;
  for (const auto& name : model.document.joints)
    if (std::find(masters.begin(), masters.end(), model.masters.at(name).source) != masters.end())
      followers.push_back(model.masters.at(name));
  return followers;
}
}  // namespace

UrdfMachine readUrdf(const std::string& xml, const UrdfOptions& options)
{
  checkTool(options);
  checkBallAxes(options.ball_axes);
  const Model model = readModel(xml);
  const Rails rails = findRails(model, options.rails);
  const Closure closure = closeLegs(model, rails, options);
  const ClosedLegs& legs = closure.legs;
  UrdfMachine urdf{
    makeMachine(model, rails, closure, options), model.tree->getRoot()->name, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}
  };
  for (std::size_t i = 0; i < 3; ++i)
  {
    urdf.slider_links[i] = rails[i].joint->child_link_name;
    urdf.tcp_links[i] = legs[i].tcp.link;
    urdf.hinges[i] = hingesOf(rails[i], legs[i]);
    urdf.drawn_rails[i] = drawnAlong(model, urdf.machine.leg(static_cast<int>(i)));
  }
  urdf.followers = followersIn(model, rails, legs);
  urdf.tool_point = toolPointOf(closure, options);
  urdf.gap = gapOf(closure, urdf.machine);
  urdf.warnings = warningsAbout(model, rails, closure);
  urdf.moved_links = movedLinks(model);
  const StillCollisions still = stillCollisions(model, urdf.moved_links);
  urdf.still_collisions = still.zones;
  urdf.open_collisions = still.open;
  return urdf;
}

UrdfMachine readUrdfFile(const std::string& path, const UrdfOptions& options)
{
  const std::string xml = readWholeFile(path, LARGEST_TEXT);
  try
  {
    return readUrdf(xml, options);
  }
  catch (const std::invalid_argument& exception)
  {
    throw std::invalid_argument(path + ": " + exception.what());
  }
}
}  // namespace pkm_workspace
