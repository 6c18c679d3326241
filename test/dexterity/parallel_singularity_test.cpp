// SPDX-License-Identifier: BSD-3-Clause
// Parallel singularities that no change of sign between halves of a box tells.
#include <gtest/gtest.h>

#include "pkm_workspace/dexterity/singularity.h"
#include "pkm_workspace/machine/catalogue.h"
#include "pkm_workspace/urdf_io/urdf_reader.h"
#include "support/oracle.h"

namespace pkm_workspace
{
namespace
{
using Status = SingularityAnswer::Status;
using Eigen::Vector3d;

/// By the definitions, in 100 digits: corners of the box count in either aspect, so that det A has a zero between them.
void expectChangeOfAspect(const Machine& machine, const Box& box)
{
  for (const Criterion::Aspect aspect : { Criterion::Aspect::OWN, Criterion::Aspect::OTHER })
  {
    Criterion criterion;
    criterion.set = Criterion::Set::REACHABLE;
    criterion.aspect = aspect;
    criterion.joint_limits = true;
    const test::Oracle oracle(machine, criterion);
    bool counts = false;
    for (int corner = 0; corner < 8; ++corner)
      counts = counts || oracle.isGood(Vector3d((corner & 1 ? box.lower : box.upper).x(),
                                                (corner & 2 ? box.lower : box.upper).y(),
                                                (corner & 4 ? box.lower : box.upper).z()));
    EXPECT_TRUE(counts) << box.lower.transpose() << " to " << box.upper.transpose();
  }
}
}  // namespace

// Rails in one plane: det A changes its sign in a plane of coordinates, where bisection of a symmetric box cuts.
TEST(ParallelSingularity, parallelWhereBisectionCutsAlongTheZeros)
{
  for (const char* name : { "coplanar_rails", "triaglide" })
    for (const Criterion::Aspect aspect : { Criterion::Aspect::OWN, Criterion::Aspect::OTHER, Criterion::Aspect::BOTH })
    {
      SCOPED_TRACE(name);
      const Machine machine =
          readUrdfFile(PKM_WORKSPACE_SOURCE_DIR "/test/data/" + std::string(name) + ".urdf").machine;
      SingularityQuery query;
      query.joint_limits = true;
      query.aspect = aspect;
      const SingularityAnswer found = findSingularities(machine, query).parallel;
      ASSERT_EQ(found.status, Status::PROVED);
      EXPECT_EQ(found.least, Interval(0.0));
      EXPECT_LE(found.box->maxWidth(), 1e-5);
      EXPECT_LE(found.boxes, 1000);
      expectChangeOfAspect(machine, *found.box);
    }
}

// On the sphere |p| = 1, in the octant of positive coordinates, det A is 0 with one sign on both sides
// (docs/theory.md).
TEST(ParallelSingularity, parallelWhereTheSignDoesNotChange)
{
  for (const Criterion::Aspect aspect : { Criterion::Aspect::OWN, Criterion::Aspect::BOTH })
  {
    SingularityQuery query;
    query.aspect = aspect;
    query.box = Box{ Vector3d::Constant(0.5), Vector3d::Constant(0.6) };
    const SingularityAnswer found = findSingularities(orthoglide(), query).parallel;
    ASSERT_EQ(found.status, Status::PROVED);
    EXPECT_LE(found.box->maxWidth(), 1e-14);
    EXPECT_LE(found.box->lower.norm(), 1.0);
    EXPECT_GE(found.box->upper.norm(), 1.0);
    query.box = Box{ Vector3d::Constant(0.5), Vector3d::Constant(0.57) };
    EXPECT_EQ(findSingularities(orthoglide(), query).parallel.status, Status::NONE);
  }
}
}  // namespace pkm_workspace
