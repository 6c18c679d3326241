// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <XmlRpcValue.h>

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "pkm_workspace/interval/box.h"
#include "pkm_workspace/region/largest_region.h"

namespace pkm_workspace
{
using XmlRpc::XmlRpcValue;

// Each read() sets the target from a value of the right type, or returns false. YAML writes whole numbers as integers.
inline bool read(const XmlRpcValue& value, bool& target)
{
  if (value.getType() != XmlRpcValue::TypeBoolean)
    return false;
  target = static_cast<const bool&>(value);
  return true;
}

inline bool read(const XmlRpcValue& value, int& target)
{
  if (value.getType() != XmlRpcValue::TypeInt)
    return false;
  target = static_cast<const int&>(value);
  return true;
}

inline bool read(const XmlRpcValue& value, double& target)
{
  int whole = 0;
  if (read(value, whole))
    target = whole;
  else if (value.getType() == XmlRpcValue::TypeDouble)
    target = static_cast<const double&>(value);
  else
    return false;
  return true;
}

inline bool read(const XmlRpcValue& value, std::string& target)
{
  if (value.getType() != XmlRpcValue::TypeString)
    return false;
  target = static_cast<const std::string&>(value);
  return true;
}

inline bool read(const XmlRpcValue& value, Eigen::Vector3d& target)
{
  if (value.getType() != XmlRpcValue::TypeArray || value.size() != 3)
    return false;
  return read(value[0], target.x()) && read(value[1], target.y()) && read(value[2], target.z());
}

template <class T>
inline bool read(const XmlRpcValue& value, std::vector<T>& target)
{
  if (value.getType() != XmlRpcValue::TypeArray)
    return false;
  std::vector<T> elements(static_cast<std::size_t>(value.size()));
  for (int i = 0; i < value.size(); ++i)
    if (!read(value[i], elements[static_cast<std::size_t>(i)]))
      return false;
  target = elements;
  return true;
}

/// One number for all joints, or one for each.
inline bool readForJoints(const XmlRpcValue& value, std::vector<double>& target)
{
  double number = 0.0;
  if (read(value, number))
    target = { number };
  else if (!read(value, target) || (target.size() != 1 && target.size() != 3))
    return false;
  return std::all_of(target.begin(), target.end(), [](double x) { return x > 0.0; });
}

/// One number for all legs, or three.
inline bool read(const XmlRpcValue& value, JointValues& target)
{
  double one = 0.0;
  std::vector<double> each;
  if (read(value, one))
    target = { one, one, one };
  else if (read(value, each) && each.size() == 3)
    target = { each[0], each[1], each[2] };
  else
    return false;
  return true;
}

inline bool read(const XmlRpcValue& value, std::optional<Eigen::Vector3d>& target)
{
  std::vector<double> numbers;
  if (!read(value, numbers) || numbers.size() != 3)
    return false;
  target = Eigen::Vector3d(numbers[0], numbers[1], numbers[2]);
  return true;
}

inline bool read(const XmlRpcValue& value, std::optional<double>& target)
{
  double number = 0.0;
  if (!read(value, number))
    return false;
  target = number;
  return true;
}

inline bool read(const XmlRpcValue& value, std::optional<std::array<double, 2>>& target)
{
  std::vector<double> numbers;
  if (!read(value, numbers) || numbers.size() != 2)
    return false;
  target = std::array<double, 2>{ numbers[0], numbers[1] };
  return true;
}

inline bool read(const XmlRpcValue& value, std::optional<RatioRange>& target)
{
  std::vector<double> numbers;
  if (!read(value, numbers) || numbers.size() != 2)
    return false;
  target = RatioRange{ numbers[0], numbers[1] };
  return true;
}

inline bool read(const XmlRpcValue& value, std::optional<Box>& target)
{
  std::vector<double> numbers;
  if (!read(value, numbers) || numbers.size() != 6)
    return false;
  target = Box{ { numbers[0], numbers[2], numbers[4] }, { numbers[1], numbers[3], numbers[5] } };
  return true;
}
}  // namespace pkm_workspace
