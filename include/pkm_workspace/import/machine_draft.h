// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "pkm_workspace/machine/description.h"

namespace pkm_workspace
{
/// One of the values that people give of a leg or of a machine: a key of a machine file and, with hyphens, an option of
/// `pkm urdf`.
struct DraftKey
{
  enum class Kind
  {
    LENGTH,  ///< in the draft's unit
    ANGLE,   ///< in degrees
    JOINT,   ///< a joint value: in the draft's unit, of a crank in degrees
    SPEED,   ///< in m/s or rad/s, > 0
    FORCE,   ///< in N or N m, > 0
    SIGN,    ///< -1 or 1
    WORD,    ///< one of `values`
    NAME
  };
  /// Kinds of legs that have it.
  enum Legs : unsigned
  {
    RAIL = 1,
    TELESCOPE = 2,
    CRANK = 4,
    ALL = 7
  };
  const char* name;
  Kind kind;
  std::size_t size;    ///< how many values it takes
  const char* values;  ///< what they are called, "OUT SIDE UP", or which there are, "lower|upper"
  const char* help;    ///< what it is, and what follows without it
  unsigned legs = ALL;
};

/// The names of the kinds of legs, in the order of LegDescription::Kind.
extern const std::array<const char*, 3> LEG_KINDS;

/// Of each leg, and of the machine.
const std::vector<DraftKey>& legKeys();
const std::vector<DraftKey>& machineKeys();

/// A machine in the making: values as people write them. What is not given follows from the rest, and what cannot is
/// asked for.
class MachineDraft
{
public:
  using Texts = std::vector<std::string>;

  /// As somebody said it.
  struct Given
  {
    Texts texts;
    std::string place;
    bool is_shared = true;
  };

  /// "m" or "mm": what all lengths are in.
  std::string unit = "m";
  /// The machine's name.
  std::string name = "machine";

  /// Gives a value to leg 0, 1 or 2. @param place where it was said, for refusals: "--length", "machine.yaml:12"
  /// @param is_shared whether it was said of all legs: then it does not count for those of another kind
  /// @pre as many texts as the key takes
  void setLeg(std::size_t leg, const DraftKey& key, const Texts& texts, const std::string& place, bool is_shared);
  void setMachine(const DraftKey& key, const Texts& texts, const std::string& place);
  bool isEmpty() const;

  /// @throws std::invalid_argument naming all that is missing, no number, or not to be had together
  MachineDescription finished() const;

private:
  using Values = std::map<std::string, Given>;
  class Reader;

  std::array<Values, 3> legs_;
  Values machine_;
};
}  // namespace pkm_workspace
