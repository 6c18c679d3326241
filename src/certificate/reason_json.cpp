// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <stdexcept>

#include "certificate_json.h"

namespace pkm_workspace
{
namespace certificate
{
double shortened(double x)
{
  if (x == 0.0 || !std::isfinite(x))
    return x;
  const double unit = std::pow(10.0, 7 - std::floor(std::log10(std::abs(x))));
  return std::isfinite(unit) && unit > 0.0 ? std::round(x * unit) / unit : x;
}

namespace
{
const char* nameOf(ConditionKind kind)
{
  switch (kind)
  {
    case ConditionKind::REACH:
      return "reach";
    case ConditionKind::JOINT_LOWER:
      return "joint_lower";
    case ConditionKind::JOINT_UPPER:
      return "joint_upper";
    case ConditionKind::ASPECT:
      return "aspect";
    case ConditionKind::PSI_MIN:
      return "psi_min";
    case ConditionKind::PSI_MAX:
      return "psi_max";
    default:
      throw std::logic_error("a condition that certificates do not know");
  }
}
}  // namespace

Json conditionJson(const Subject& subject, const std::array<double, 3>& v)
{
  Json json = { { "of", nameOf(subject.kind) } };
  if (subject.kind == ConditionKind::PSI_MIN || subject.kind == ConditionKind::PSI_MAX)
    json["v"] = { shortened(v[0]), shortened(v[1]), shortened(v[2]) };
  else if (subject.kind != ConditionKind::ASPECT)
    json["leg"] = subject.leg;
  return json;
}

std::optional<Json> violationJson(const BoxTest& test, const Box& box)
{
  NecessaryForms necessary;
  std::vector<FormOrigin> origins(NecessaryForms::MOST, FormOrigin{ { ConditionKind::REACH }, {}, {} });
  const GrowingVector itself = scaling(Eigen::Vector3d::Zero());
  test.kernel().necessaryForms(CenteredBox<double>(box), 0.0, &itself, 1, &necessary, origins.data());
  std::size_t worst = 0;
  for (std::size_t k = 1; k < necessary.forms && !necessary.violated; ++k)
    if (necessary.form[k].upper() < necessary.form[worst].upper())
      worst = k;
  if (!necessary.violated && (necessary.forms == 0 || !(necessary.form[worst].upper() < 0.0)))
    return std::nullopt;
  return conditionJson(origins[worst].subject, origins[worst].v);
}
}  // namespace certificate
}  // namespace pkm_workspace
