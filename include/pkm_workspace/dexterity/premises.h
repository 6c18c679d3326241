// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "pkm_workspace/common/byte_order.h"
#include "pkm_workspace/dexterity/criterion.h"
#include "pkm_workspace/machine/ball_axes.h"
#include "pkm_workspace/machine/frame.h"
#include "pkm_workspace/machine/tolerances.h"

namespace pkm_workspace
{
/// What an answer is proved of, in messages the Hypotheses: which machines, what is asked of their points, and in which
/// frame. Two answers are about the same when the bytes() of their premises are the same.
struct Premises
{
  std::string machine;        ///< its name, which makes no difference
  std::string geometry_hash;  ///< of the machine, or set of machines, in the frame of its root link
  Criterion criterion;        ///< what is asked of every point: the set and its bounds, the aspect, joint limits
  Pose root;                  ///< where the root link's frame stands in the frame of the answer
  std::string version;        ///< of pkm_workspace, which makes no difference either
  /// Where the tilt of ball joints is counted from, where that counts, in the frame of the answer: the hash knows it.
  BallAxes ball_axes = {};
  Tolerances tolerances = {};  ///< of the machine, which its hash covers; none in premises that are taken from bytes

  /// All that makes a difference: what put() puts; then where the frame is another one than the root link's,
  /// quaternion (x, y, z, w) and translation [m].
  std::string bytes() const;
  /// A name for exactly these bytes: a UUID (version 5).
  std::string hash() const;
};

/// Whether they are about the same.
bool operator==(const Premises& one, const Premises& other);

/// The same criterion, but within joint limits only where the machine has any: without them, that asks for nothing.
Criterion within(const Machine& machine, Criterion criterion);

/// Of what is asked in the frame of the machine's root link, proved by this version.
Premises premisesOf(const Machine& machine, const Criterion& criterion);
/// The same in another frame, in which the machine and the criterion are given.
/// @param geometry_hash of the machine in the frame of its root link @param root where that stands
Premises premisesIn(const Pose& root, const Machine& machine, const std::string& geometry_hash,
                    const Criterion& criterion);

/// Puts geometry hash and criterion: all premises of an answer in the frame of the root link.
void put(const Premises& premises, ByteWriter& writer);
/// Takes them out again; name and version are empty. @throws std::runtime_error as takeCriterion()
Premises takePremises(ByteReader& reader);

/// One thing in which premises differ, in words.
struct Difference
{
  std::string what;
  std::string one;
  std::string other;
};

/// Everything in which they differ: nothing iff they are equal.
std::vector<Difference> differences(const Premises& one, const Premises& other);

/// What a picture holds for, in two short lines: the machine, its geometry by the first digits of the hash, and the
/// version; then the criterion. The frame is that of the picture.
std::string describe(const Premises& premises);
}  // namespace pkm_workspace
