// SPDX-License-Identifier: BSD-3-Clause
#include "number_text.h"

#include <locale>
#include <sstream>

namespace pkm_workspace
{
namespace urdf_io
{
namespace
{
bool readsBackAs(double value, const std::string& text)
{
  std::istringstream stream(text);
  stream.imbue(std::locale::classic());
  double read = 0.0;
  return stream >> read && read == value;
}
}  // namespace

std::string roundedText(double value, int digits)
{
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text.precision(digits);
  text << value + 0.0;  // -0 becomes 0
  return text.str();
}

std::string numberText(double value)
{
  for (const int digits : { 15, 16 })
  {
    const std::string text = roundedText(value, digits);
    if (readsBackAs(value, text))
      return text;
  }
  return roundedText(value, 17);
}

std::string vectorText(const Eigen::Vector3d& v)
{
  return numberText(v.x()) + " " + numberText(v.y()) + " " + numberText(v.z());
}
}  // namespace urdf_io
}  // namespace pkm_workspace
