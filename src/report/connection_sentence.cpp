// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/report/connection_sentence.h"

#include "pkm_workspace/dexterity/criterion_text.h"
#include "pkm_workspace/interval/decimal.h"

namespace pkm_workspace
{
namespace
{
std::string counted(std::size_t count, const std::string& what)
{
  return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

std::string placeOfZero(BoxVerdict zero, std::optional<std::size_t> at)
{
  if (at)
    return " The zero configuration is in component " + std::to_string(*at + 1) + ".";
  if (zero == BoxVerdict::OUTSIDE)
    return " The zero configuration is not in the set.";
  return " The zero configuration is in no box that is inside: a finer resolution may show its component.";
}
}  // namespace

std::string partOfSet(bool is_whole)
{
  return is_whole ? "the set" : "the part of the set in the box";
}

std::string describe(const Components& components, bool is_whole, BoxVerdict zero, std::optional<std::size_t> at)
{
  const std::size_t found = components.list().size();
  const std::size_t clusters = components.clusters();
  if (!components.complete())
    return "The time was over before it was looked at which boxes hang together.";
  if (found == 0)
    return "No box is inside: nothing is known of connected components.";
  std::string text = "Proved: the boxes inside form " + counted(found, "connected component");
  if (clusters > 1)
    text += ", and no path in " + partOfSet(is_whole) + " joins any two of the " + counted(clusters, "cluster") +
            " that these form";
  text += ".";
  if (found > clusters)
    text += " Undecided boxes may join components of one cluster: a finer resolution may settle that.";
  return text + placeOfZero(zero, at);
}

std::string connectedSentence(std::size_t lines, const Machine& machine, const Criterion& criterion)
{
  return "Proved: the points are connected, and every point of the path of " + counted(lines, "line") +
         " that joins them is " + quality(machine, criterion) + ".";
}

std::string apartSentence(bool is_whole, const Machine& machine, const Criterion& criterion)
{
  return "Proved: the points are apart. Both are " + quality(machine, criterion) + ", and no path in " +
         partOfSet(is_whole) + " joins them.";
}

std::string openSentence(double resolution, const std::string& ended_by)
{
  return "Not decided at the resolution of " + nearly(resolution, 3) + " m whether the points are connected: " +
         (ended_by.empty() ? "undecided boxes may join them or not; a finer resolution may settle it."
                           : ended_by + " ended the computation; a larger one may settle it.");
}
}  // namespace pkm_workspace
