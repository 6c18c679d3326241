// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <stdexcept>

#include "certificate_json.h"

namespace pkm_workspace
{
namespace certificate
{
/// As a whole number and a power of ten: shortest fractions take several times as long.
void appendShort(double x, std::string& text)
{
  int power = x == 0.0 || !std::isfinite(x) ? 0 : static_cast<int>(std::floor(std::log10(std::abs(x)))) - 7;
  const double scaled = x * std::pow(10.0, -power);
  if (x == 0.0 || !std::isfinite(scaled))
  {
    text += Json(x).dump();
    return;
  }
  std::int64_t digits = std::llround(scaled);
  for (; digits % 10 == 0; ++power)
    digits /= 10;
  text += std::to_string(digits);
  if (power != 0)
    text += 'e' + std::to_string(power);
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

void appendCondition(const Subject& subject, const std::array<double, 3>& v, std::string& text)
{
  text += "\"of\":\"";
  text += nameOf(subject.kind);
  text += '"';
  if (subject.kind != ConditionKind::PSI_MIN && subject.kind != ConditionKind::PSI_MAX)
  {
    if (subject.kind != ConditionKind::ASPECT)
      text += ",\"leg\":" + std::to_string(subject.leg);
    return;
  }
  for (std::size_t k = 0; k < 3; ++k)
  {
    text += k == 0 ? ",\"v\":[" : ",";
    appendShort(v[k], text);
  }
  text += ']';
}

bool appendViolation(const BoxTest& test, const Box& box, std::string& text)
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
    return false;
  appendCondition(origins[worst].subject, origins[worst].v, text);
  return true;
}
}  // namespace certificate
}  // namespace pkm_workspace
