// SPDX-License-Identifier: BSD-3-Clause
#include <stdexcept>

#include "common_options.h"
#include "pkm_workspace/import/tolerance_file.h"

namespace pkm_workspace
{
namespace cli
{
namespace
{
constexpr const char* AGAIN = "given a second time for the same machine";

std::string helpOf(const ToleranceKind& kind)
{
  return "answers hold for all machines that were built within these, in place of what the URDF says: tolerance " +
         std::string(kind.help) + ", in " + kind.unit +
         (kind.is_per_axis ? "; one number, one for each leg, or x, y, z of each leg"
                           : "; one number, or one for each leg");
}
}  // namespace

GivenTolerances ToleranceWish::both() const
{
  GivenTolerances all = by_file.value_or(GivenTolerances());
  for (const ToleranceKind& kind : TOLERANCE_KINDS)
    if (by_option.has(kind))
      all.set(kind, by_option.numbers(kind));
  return all;
}

void declareTolerances(Options& options, const std::function<ToleranceWish&()>& wish, const std::string& about)
{
  options.repeated("tolerances", "FILE",
                   "all of them from a file in YAML, under the names of these options with _ in place of - "
                   "(docs/tolerances.md); an option counts in place of what the file says" +
                       about,
                   [wish](const Words& words) {
                     std::optional<GivenTolerances>& file = wish().by_file;
                     if (file)
                       throw std::invalid_argument(AGAIN);
                     file = readToleranceFile(words[0]);
                   });
  for (const ToleranceKind& kind : TOLERANCE_KINDS)
    options.lists(optionOf(kind.name), "NUMBER..", helpOf(kind) + about, [wish, &kind](const Words& words) {
      GivenTolerances& given = wish().by_option;
      if (given.has(kind))
        throw std::invalid_argument(AGAIN);
      given.set(kind, readNumbers(words, Quantity()));
    });
}

void MachinesOptions::declareTolerances(Options& options)
{
  cli::declareTolerances(
      options, [this]() -> ToleranceWish& { return latest().tolerances; }, AFTER_URDF);
}

Words toleranceOptions()
{
  Words names = { "tolerances" };
  for (const ToleranceKind& kind : TOLERANCE_KINDS)
    names.push_back(optionOf(kind.name));
  return names;
}
}  // namespace cli
}  // namespace pkm_workspace
