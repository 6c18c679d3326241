// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "common_options.h"
#include "pkm_workspace/dexterity/joint_data.h"

namespace pkm_workspace
{
namespace cli
{
std::string optionOf(std::string name)
{
  std::replace(name.begin(), name.end(), '_', '-');
  return name;
}

void declareJointData(Options& options, Criterion& criterion, const std::function<bool(const JointDatum&)>& has)
{
  for (const JointDatum& datum : JOINT_DATA)
    if (has(datum))
      options.legs(optionOf(datum.name), "NUMBER", datum.help + std::string(", in ") + datum.unit,
                   [&values = criterion.*datum.values, &datum](const Words& words) {
                     const double most = datum.most < LARGEST_BOUND ? datum.most : INF;
                     const std::vector<double> numbers = readNumbers(words, Quantity{ datum.unit, 0.0, false, most });
                     for (std::size_t leg = 0; leg < 3; ++leg)
                       values[leg] = numbers[numbers.size() == 1 ? 0 : leg];
                   });
}

/// What is known of the joints counts with its bound; their speeds on paths, too.
void requireEffect(Options& options, const Criterion& criterion)
{
  for (const JointDatum& datum : JOINT_DATA)
    options.check({ optionOf(datum.name) }, [&options, &criterion, &datum](Problems& problems) {
      const bool has_feed = options.has("gcode") && options.given("gcode");
      const bool is_rate = datum.bound == &Criterion::tool_speed_min &&
                           (options.given("tool-speed") || options.given("largest-feed") || has_feed);
      if (options.given(optionOf(datum.name)) && criterion.*datum.bound == 0.0 && !is_rate)
        problems.push_back("is without effect: it counts for --" + optionOf(boundOf(datum).name) +
                           (options.has("tool-speed") && datum.bound == &Criterion::tool_speed_min
                                ? ", and for --tool-speed and --largest-feed"
                                : ""));
    });
}
}  // namespace cli
}  // namespace pkm_workspace
