// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include "pkm_workspace/paving/paving.h"
#include "support/machines.h"
#include "support/same_bits.h"

namespace pkm_workspace
{
namespace test
{
/// Of the cube [-1, 1]^3.
inline PavingQuery query(double resolution, Criterion::Set set = Criterion::Set::DEXTROUS,
                         Criterion::Aspect aspect = Criterion::Aspect::OWN)
{
  PavingQuery query;
  query.criterion.set = set;
  query.criterion.aspect = aspect;
  query.box = Box{ Eigen::Vector3d::Constant(-1.0), Eigen::Vector3d::Constant(1.0) };
  query.resolution = resolution;
  return query;
}

/// Rails that are apart from parallel by far less than a set with an end needs.
inline Machine nearlyParallel()
{
  Machine::Legs legs = uranesx().legs();
  const IntervalVector direction = enclose(Eigen::Vector3d(1e-6, 0.0, 1.0));
  const Interval length = norm(direction);
  slidingStrut(legs[0]).axis = { direction[0] / length, direction[1] / length, direction[2] / length };
  return Machine("nearly_parallel", legs, uranesx().zero());
}

/// Bit for bit: the tree, the counts and the volumes.
inline void expectSame(const Paving& a, const Paving& b)
{
  EXPECT_TRUE(a.premises == b.premises);
  EXPECT_EQ(a.premises.machine, b.premises.machine);
  EXPECT_EQ(a.premises.version, b.premises.version);
  for (int axis = 0; axis < 3; ++axis)
  {
    EXPECT_TRUE(sameBits(a.box.lower[axis], b.box.lower[axis]));
    EXPECT_TRUE(sameBits(a.box.upper[axis], b.box.upper[axis]));
  }
  EXPECT_EQ(a.tree.bisection().depth(), b.tree.bisection().depth());
  ASSERT_EQ(a.tree.levels(), b.tree.levels());
  for (std::size_t level = 0; level < a.tree.levels(); ++level)
    ASSERT_TRUE(a.tree.level(level) == b.tree.level(level)) << "level " << level;
  EXPECT_TRUE(sameBits(a.volumeLower(), b.volumeLower()));
  EXPECT_TRUE(sameBits(a.volumeUpper(), b.volumeUpper()));
  EXPECT_EQ(a.volume_inside, b.volume_inside);
  EXPECT_EQ(a.volume_boundary, b.volume_boundary);
  EXPECT_EQ(a.boxes, b.boxes);
  EXPECT_EQ(a.complete, b.complete);
}
}  // namespace test
}  // namespace pkm_workspace
