// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "pkm_workspace/common/problems.h"
#include "pkm_workspace/machine/machine.h"

namespace pkm_workspace
{
/// Of the three legs: all zero where the machine is taken for exact.
using Tolerances = std::array<StrutTolerance, 3>;

/// A kind of tolerance, and all that people and programs are told of it.
struct ToleranceKind
{
  const char* name;  ///< of parameter, key of files, message field and JSON member; an option has '-' for '_'
  const char* unit;
  double most;                                   ///< of what is allowed
  bool is_per_axis;                              ///< one number for each coordinate
  double* (*values)(StrutTolerance& tolerance);  ///< its one number or three
  const char* help;
};

extern const std::array<ToleranceKind, 7> TOLERANCE_KINDS;

/// The kind of that name, or nullptr.
const ToleranceKind* toleranceKind(const std::string& name);

/// Sets one kind for all legs: one number for everything, one for each leg, or (for coordinates) x, y, z for all legs
/// or for each leg in turn.
/// @throws std::invalid_argument for another count of numbers, or one out of range
void setTolerance(const ToleranceKind& kind, const std::vector<double>& numbers, Tolerances& tolerances);

/// The same of one leg alone: one number, or x, y, z.
void setTolerance(const ToleranceKind& kind, const std::vector<double>& numbers, StrutTolerance& tolerance);

/// Tolerances as somebody gives them in place of others (docs/tolerances.md): a kind that is not given stays as it was.
class GivenTolerances
{
public:
  /// @throws std::invalid_argument as setTolerance() does
  void set(const ToleranceKind& kind, const std::vector<double>& numbers);
  bool has(const ToleranceKind& kind) const { return !numbers(kind).empty(); }
  /// As they were given; none where the kind was not.
  const std::vector<double>& numbers(const ToleranceKind& kind) const { return numbers_[indexOf(kind)]; }
  bool isEmpty() const;
  Tolerances over(Tolerances others) const;

private:
  static std::size_t indexOf(const ToleranceKind& kind)
  {
    return static_cast<std::size_t>(&kind - TOLERANCE_KINDS.data());
  }
  std::array<std::vector<double>, 7> numbers_;
};

/// Its numbers: as few of them as say the same, so one or three (a leg each), or nine.
std::vector<double> numbersOf(const ToleranceKind& kind, const Tolerances& tolerances);

Tolerances tolerancesOf(const Machine& machine);
bool areZero(const Tolerances& tolerances);

/// All machines within tolerances of this one, whose own ones are left out.
/// @throws std::invalid_argument where one of them has no zero configuration, or a singular one
Machine withTolerances(const Machine& machine, const Tolerances& tolerances);

/// The machine with those that are given in place of its own. @throws std::invalid_argument as above
Machine withGivenTolerances(const Machine& machine, const GivenTolerances& given);

/// One machine within the tolerances of this one, which has none itself.
/// @param parameters as ParameterSet counts them, leg by leg @throws std::invalid_argument where it is singular at zero
Machine builtWith(const Machine& machine, const std::array<double, 3 * STRUT_PARAMETERS>& parameters);

/// "strut lengths +-0.0001 m, rails +-0.0035 rad" or "" where there are none.
std::string inWords(const Tolerances& tolerances);
}  // namespace pkm_workspace
