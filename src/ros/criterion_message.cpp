// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/ros/criterion_message.h"

#include <limits>

#include "pkm_workspace/interval/text_stream.h"
#include "pkm_workspace/ros/solid_message.h"
#include "pkm_workspace/version.h"

namespace pkm_workspace
{
namespace
{
/// 0 is the default, +inf is none: 0 in a Criterion.
double boundOr(double value, double fallback)
{
  return value == std::numeric_limits<double>::infinity() ? 0.0 : valueOr(value, fallback);
}

static_assert(Hypotheses::OWN == 1 && Hypotheses::OTHER == 2 && Hypotheses::BOTH == 3, "numbers as Criterion::Aspect");

std::uint8_t toNumber(Criterion::Aspect aspect)
{
  return static_cast<std::uint8_t>(static_cast<int>(aspect) + Hypotheses::OWN);
}

Criterion::Aspect fromNumber(std::uint8_t aspect)
{
  return aspect == Hypotheses::OTHER  ? Criterion::Aspect::OTHER
         : aspect == Hypotheses::BOTH ? Criterion::Aspect::BOTH
                                      : Criterion::Aspect::OWN;
}

void readSet(const CriterionRequest& request, Criterion& criterion, Problems& problems)
{
  if (request.set == CriterionRequest::DEXTROUS)
    criterion.set = Criterion::Set::DEXTROUS;
  else if (request.set == CriterionRequest::REACHABLE)
    criterion.set = Criterion::Set::REACHABLE;
  else if (request.set != CriterionRequest::DEFAULT)
    problems.push_back("set = " + std::to_string(request.set) + " must be DEFAULT = 0, DEXTROUS = 1 or REACHABLE = 2");
}

void readFactors(const CriterionRequest& request, Criterion& criterion, Problems& problems)
{
  if (criterion.set == Criterion::Set::REACHABLE && (request.psi_min != 0.0 || request.psi_max != 0.0))
    problems.push_back("psi_min and psi_max must be 0 unless the set is DEXTROUS: in a reachable set they are free");
  criterion.psi_min = valueOr(request.psi_min, criterion.psi_min);
  criterion.psi_max = valueOr(request.psi_max, criterion.psi_max);
  criterion.force_min = boundOr(request.force_min, criterion.force_min);
  criterion.force_max = boundOr(request.force_max, criterion.force_max);
  criterion.kappa_max = boundOr(request.kappa_max, criterion.kappa_max);
}
}  // namespace

Criterion fromMessage(const CriterionRequest& request, const Criterion& defaults, Problems& problems)
{
  Criterion criterion = defaults;
  const std::size_t before = problems.size();
  readSet(request, criterion, problems);
  criterion.aspect = aspectOf(request.aspect, defaults.aspect, problems);
  readFactors(request, criterion, problems);
  if (request.joint_limits == CriterionRequest::ON || request.joint_limits == CriterionRequest::OFF)
    criterion.joint_limits = request.joint_limits == CriterionRequest::ON;
  else if (request.joint_limits != CriterionRequest::DEFAULT)
    problems.push_back("joint_limits = " + std::to_string(request.joint_limits) +
                       " must be DEFAULT = 0, ON = 1 or OFF = 2");
  const Origin origin = [&request](const std::string& name) {
    const double value = name == "psi_min"     ? request.psi_min
                         : name == "psi_max"   ? request.psi_max
                         : name == "force_min" ? request.force_min
                                               : request.force_max;
    return value == 0.0 ? "the node's" : "";
  };
  validateCriterion(criterion, origin, problems);
  if (problems.size() == before)
    return criterion;
  Criterion valid = defaults;
  valid.set = criterion.set;
  valid.aspect = criterion.aspect;
  return valid;
}

std::optional<Box> readCorners(bool given, const geometry_msgs::Point& min_corner,
                               const geometry_msgs::Point& max_corner, const std::string& flag, Problems& problems)
{
  const Box corners{ { min_corner.x, min_corner.y, min_corner.z }, { max_corner.x, max_corner.y, max_corner.z } };
  if (given)
  {
    const std::size_t before = problems.size();
    requireFinite("min_corner", corners.lower, problems);
    requireFinite("max_corner", corners.upper, problems);
    return problems.size() == before ? std::optional<Box>(corners) : std::nullopt;
  }
  if (corners.lower != Eigen::Vector3d::Zero() || corners.upper != Eigen::Vector3d::Zero())
    problems.push_back("min_corner and max_corner must be 0 [m] unless " + flag + " is true");
  return std::nullopt;
}

double timeLimitOf(double requested, double node, double longest, Problems& problems)
{
  const double time_limit = valueOr(requested, node);
  if (time_limit > 0.0 && time_limit <= longest)
    return time_limit;
  TextStream text;
  text << "time_limit = " << time_limit << " s must be positive and at most ";
  if (longest > node)
    text << longest << " s, or 0 for the node's ~time_limit, " << node << " s";
  else
    text << "the node's ~time_limit, " << node << " s, or 0 for it";
  problems.push_back(text.str());
  return node;
}

Criterion::Aspect aspectOf(std::uint8_t aspect, Criterion::Aspect fallback, Problems& problems)
{
  if (aspect == 0)
    return fallback;
  if (aspect <= Hypotheses::BOTH)
    return fromNumber(aspect);
  problems.push_back("aspect = " + std::to_string(aspect) + " must be OWN = 1, OTHER = 2 or BOTH = 3, or 0 for " +
                     name(fallback));
  return fallback;
}

Hypotheses hypothesesOf(const FramedMachine& in, const Criterion& criterion, double accuracy)
{
  const bool dextrous = criterion.set == Criterion::Set::DEXTROUS;
  Hypotheses message;
  message.machine = in.machine->name();
  message.geometry_hash = in.geometry_hash;
  message.root = in.root;
  message.version = version();
  message.set = dextrous ? Hypotheses::DEXTROUS : Hypotheses::REACHABLE;
  message.aspect = toNumber(criterion.aspect);
  message.psi_min = dextrous ? criterion.psi_min : 0.0;
  message.psi_max = dextrous ? criterion.psi_max : 0.0;
  message.force_min = criterion.force_min;
  message.force_max = criterion.force_max;
  message.kappa_max = criterion.kappa_max;
  message.joint_limits = criterion.joint_limits;
  message.accuracy = accuracy;
  return message;
}

std::string captionOf(const Hypotheses& hypotheses, const std::string& precision)
{
  constexpr std::size_t ENOUGH = 8;  // digits of a hash to tell machines apart
  Criterion criterion;
  criterion.set = hypotheses.set == Hypotheses::DEXTROUS ? Criterion::Set::DEXTROUS : Criterion::Set::REACHABLE;
  criterion.aspect = fromNumber(hypotheses.aspect);
  criterion.psi_min = hypotheses.psi_min;
  criterion.psi_max = hypotheses.psi_max;
  criterion.force_min = hypotheses.force_min;
  criterion.force_max = hypotheses.force_max;
  criterion.kappa_max = hypotheses.kappa_max;
  criterion.joint_limits = hypotheses.joint_limits;
  TextStream text;
  text << hypotheses.machine << ", geometry " << hypotheses.geometry_hash.substr(0, ENOUGH) << ", pkm_workspace "
       << hypotheses.version << '\n'
       << describe(criterion);
  if (!precision.empty())
    text << ", " << precision << ' ' << hypotheses.accuracy << " m";
  return text.str();
}
}  // namespace pkm_workspace
