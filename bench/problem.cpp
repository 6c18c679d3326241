// SPDX-License-Identifier: BSD-3-Clause
#include "problem.h"

#include "natural_polynomial.h"
#include "pkm_workspace/dexterity/characteristic_polynomial.h"
#include "pkm_workspace/dexterity/workspace_bounds.h"
#include "pkm_workspace/machine/catalogue.h"

namespace pkm_workspace
{
namespace bench
{
Problem orthoglideCube()
{
  const Machine machine = orthoglide();
  return { "Orthoglide, cube", machine, false, workspaceBounds(machine, Criterion()) };
}

Problem uranesxSquare()
{
  const Machine machine = uranesx();
  const Eigen::Vector3d reach(machine.scale(), machine.scale(), 0.0);  // the rails run along z
  return { "UraneSX, square", machine, true, { machine.zero() - reach, machine.zero() + reach } };
}

LargestRegion findByOurWay(const Machine& machine, bool is_square, double accuracy, const Criterion& criterion)
{
  RegionQuery query;
  query.shape = is_square ? makeSquare() : makeCube();
  query.accuracy = accuracy;
  query.criterion = criterion;
  query.budget.threads = 1;
  query.budget.time_limit = 10.0;
  return findLargestRegion(machine, query);
}

std::vector<std::pair<std::string, BoxClassifier>> paperTests(const Machine& machine)
{
  return { { "paper, our verdicts", BoxTest(machine, Criterion()) },
           { "paper, polynomial with derivatives", CharacteristicTest(machine, Criterion()) },
           { "paper, polynomial as written", NaturalPolynomial(machine) } };
}
}  // namespace bench
}  // namespace pkm_workspace
