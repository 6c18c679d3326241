// SPDX-License-Identifier: BSD-3-Clause
#include <stdexcept>

#include "common_options.h"
#include "pkm_workspace/import/tolerance_file.h"

namespace pkm_workspace
{
namespace cli
{
void declareTolerances(Options& options, Tolerances& tolerances)
{
  options.words("tolerances", "FILE",
                "all of them from a file in YAML, under the names of these options with _ in place of - "
                "(docs/tolerances.md); those that follow count in place of the file's",
                [&tolerances](const Words& words) { tolerances = readToleranceFile(words[0]); });
  for (const ToleranceKind& kind : TOLERANCE_KINDS)
    options.lists(optionOf(kind.name), "NUMBER..",
                  "answers hold for all machines that were built within these: tolerance " + std::string(kind.help) +
                      ", in " + kind.unit +
                      (kind.is_per_axis ? "; one number, one for each leg, or x, y, z of each leg"
                                        : "; one number, or one for each leg"),
                  [&tolerances, &kind, is_given = false](const Words& words) mutable {
                    if (is_given)
                      throw std::invalid_argument("given a second time");
                    is_given = true;
                    setTolerance(kind, readNumbers(words, Quantity()), tolerances);
                  });
}
}  // namespace cli
}  // namespace pkm_workspace
