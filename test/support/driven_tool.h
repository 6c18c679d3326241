// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <boost/math/constants/constants.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "pkm_workspace/dexterity/condition.h"
#include "pkm_workspace/dexterity/criterion.h"

namespace pkm_workspace
{
namespace test
{
/// What motors, drives and encoders make of a tool at one point, by the definitions: with the Jacobian J of
/// pdot = J qdot as an inverse of numbers. Not by the conditions' matrices.
template <class N>
class DrivenToolOf
{
public:
  using Number = N;
  using Vector = std::array<Number, 3>;
  using Matrix = std::array<Vector, 3>;

  /// @param strut vectors from A to B @param eta their parts along the rails
  DrivenToolOf(const Criterion& criterion, const Matrix& strut, const Vector& eta)
    : criterion_(criterion), strut_(strut), eta_(eta), inverse_of_struts_(inverse(strut))
  {
    for (std::size_t row = 0; row < 3; ++row)
      for (std::size_t i = 0; i < 3; ++i)
        jacobian_[row][i] = inverse_of_struts_[row][i] * eta[i];
  }

  /// Of all legs the worst one.
  Number valueOf(ConditionKind kind) const
  {
    switch (kind)
    {
      case ConditionKind::TOOL_SPEED_MIN:
        return worst(true, [this](std::size_t i) { return toolSpeed(i); });
      case ConditionKind::TOOL_FORCE_MIN:
        return worst(true, [this](std::size_t i) { return toolForce(i); });
      case ConditionKind::STIFFNESS_MIN:
        return 1 / extremeEigenvalues(compliance()).second;
      case ConditionKind::POSITION_ERROR_MAX:
        return largestError();
      case ConditionKind::STRUT_ANGLE_MIN:
        return worst(true, [this](std::size_t i) { return angle(i); });
      case ConditionKind::STRUT_ANGLE_MAX:
        return worst(false, [this](std::size_t i) { return angle(i); });
      default:
        throw std::logic_error("no condition of drives");
    }
  }

  /// qdot of a velocity of the tool.
  Vector jointSpeeds(const Vector& velocity) const
  {
    Vector speeds;
    for (std::size_t i = 0; i < 3; ++i)
      speeds[i] = dot(strut_[i], velocity) / eta_[i];
    return speeds;
  }

  /// The joints' forces that hold a force at the tool: J^T f.
  Vector jointForces(const Vector& force) const
  {
    Vector forces;
    for (std::size_t i = 0; i < 3; ++i)
      forces[i] = jacobian_[0][i] * force[0] + jacobian_[1][i] * force[1] + jacobian_[2][i] * force[2];
    return forces;
  }

  /// How the tool gives way: drives by their forces over their stiffness, struts by theirs.
  Vector deflection(const Vector& force) const
  {
    const Vector joints = jointForces(force);
    Vector given = { 0, 0, 0 };
    for (std::size_t i = 0; i < 3; ++i)
    {
      using std::sqrt;
      const Number length = sqrt(dot(strut_[i], strut_[i]));
      const Number in_strut = joints[i] / eta_[i] * length;  // the slider feels its part along the rail
      const double stiffness = criterion_.strut_stiffness[i];
      const Number longer = stiffness > 0.0 ? Number(in_strut / stiffness) : Number(0);
      for (std::size_t row = 0; row < 3; ++row)
        given[row] += jacobian_[row][i] * joints[i] / criterion_.joint_stiffness[i] +
                      inverse_of_struts_[row][i] * length * longer;
    }
    return given;
  }

  /// The error of the tool's position for one error of each joint.
  Vector error(const Vector& joints) const
  {
    return { dot(jacobian_[0], joints), dot(jacobian_[1], joints), dot(jacobian_[2], joints) };
  }

private:
  static Number dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
  static Vector cross(const Vector& a, const Vector& b)
  {
    return { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] };
  }
  static Number determinant(const Matrix& m) { return dot(m[0], cross(m[1], m[2])); }

  static Matrix inverse(const Matrix& m)
  {
    const Matrix columns = { cross(m[1], m[2]), cross(m[2], m[0]), cross(m[0], m[1]) };
    Matrix result;
    for (std::size_t row = 0; row < 3; ++row)
      for (std::size_t column = 0; column < 3; ++column)
        result[row][column] = columns[column][row] / determinant(m);
    return result;
  }

  template <class Value>
  static Number worst(bool is_least, const Value& value)
  {
    Number result = value(0);
    for (const std::size_t i : { 1U, 2U })
      if (const Number other = value(i); is_least == (other < result))
        result = other;
    return result;
  }

  /// The tool is fastest for joint i in the direction of its row of J^-1.
  Number toolSpeed(std::size_t i) const
  {
    using std::sqrt;
    const Vector row = { strut_[i][0] / eta_[i], strut_[i][1] / eta_[i], strut_[i][2] / eta_[i] };
    return criterion_.joint_speed_max[i] / sqrt(dot(row, row));
  }
  Number toolForce(std::size_t i) const
  {
    using std::sqrt;
    const Vector column = { jacobian_[0][i], jacobian_[1][i], jacobian_[2][i] };
    return criterion_.joint_effort_max[i] / sqrt(dot(column, column));
  }
  Number angle(std::size_t i) const
  {
    using std::abs, std::acos, std::sqrt;
    const Number cosine = abs(eta_[i]) / sqrt(dot(strut_[i], strut_[i]));
    return acos(cosine > 1 ? Number(1) : cosine);
  }

  Matrix compliance() const
  {
    Matrix result;
    for (std::size_t column = 0; column < 3; ++column)
    {
      Vector unit = { 0, 0, 0 };
      unit[column] = 1;
      const Vector given = deflection(unit);
      for (std::size_t row = 0; row < 3; ++row)
        result[row][column] = given[row];
    }
    return result;
  }

  Number largestError() const
  {
    using std::sqrt;
    Number largest = 0;
    for (int signs = 0; signs < 8; ++signs)
    {
      Vector joints;
      for (std::size_t i = 0; i < 3; ++i)
        joints[i] = ((signs >> i) & 1) != 0 ? criterion_.joint_error_max[i] : -criterion_.joint_error_max[i];
      const Vector off = error(joints);
      if (const Number length = sqrt(dot(off, off)); length > largest)
        largest = length;
    }
    return largest;
  }

public:
  /// The least and the largest eigenvalue of a symmetric matrix, by the trigonometric roots of its cubic.
  static std::pair<Number, Number> extremeEigenvalues(Matrix m)
  {
    using std::acos, std::cos, std::sqrt;
    const Number mean = (m[0][0] + m[1][1] + m[2][2]) / 3;
    Number squares = 0;
    for (std::size_t i = 0; i < 3; ++i)
    {
      m[i][i] -= mean;
      squares += dot(m[i], m[i]);
    }
    const Number spread = sqrt(squares / 6);
    if (spread == 0)
      return { mean, mean };
    const Number cosine = determinant(m) / (2 * spread * spread * spread);
    const Number turn = acos(cosine < -1 ? Number(-1) : cosine > 1 ? Number(1) : cosine) / 3;
    const Number third = 2 * boost::math::constants::pi<Number>() / 3;
    return { mean + 2 * spread * cos(turn + third), mean + 2 * spread * cos(turn) };
  }

private:
  Criterion criterion_;
  Matrix strut_;
  Vector eta_;
  Matrix inverse_of_struts_;  ///< A^-1
  Matrix jacobian_;
};

using DrivenTool = DrivenToolOf<boost::multiprecision::cpp_bin_float_100>;
}  // namespace test
}  // namespace pkm_workspace
