// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/machine/zone_keys.h"

#include <algorithm>
#include <optional>
#include <stdexcept>

#include "pkm_workspace/common/text.h"
#include "pkm_workspace/interval/decimal.h"

namespace pkm_workspace
{
namespace
{
constexpr std::size_t LONGEST_SHOWN = 60;

std::vector<double*> pointers(Eigen::Vector3d& v)
{
  return { &v[0], &v[1], &v[2] };
}

bool has(const ZoneKey& key, ZoneKind kind)
{
  return std::find(key.kinds.begin(), key.kinds.end(), kind) != key.kinds.end();
}

std::optional<ZoneKind> kindOf(const std::string& name)
{
  const auto found = std::find(ZONE_KINDS.begin(), ZONE_KINDS.end(), name);
  if (found == ZONE_KINDS.end())
    return std::nullopt;
  return static_cast<ZoneKind>(found - ZONE_KINDS.begin());
}

ZoneKind requireKind(const std::string& name)
{
  if (const auto kind = kindOf(name))
    return *kind;
  throw std::invalid_argument("'" + shortened(name, LONGEST_SHOWN) + "' is no kind of zone; these are: " +
                              joined({ ZONE_KINDS.begin(), ZONE_KINDS.end() }, ", "));
}

std::string keysOf(ZoneKind kind)
{
  std::vector<std::string> names;
  for (const ZoneKey& key : zoneKeys())
    if (has(key, kind))
      names.emplace_back(key.name);
  return joined(names, ", ");
}

/// "box X Y Z SX SY SZ".
std::string wordsOf(ZoneKind kind)
{
  std::string words = ZONE_KINDS[static_cast<std::size_t>(kind)];
  for (const ZoneKey& key : zoneKeys())
    if (key.is_required && has(key, kind))
      words += std::string(" ") + key.values;
  return words;
}

void readKey(const ZoneKey& key, const std::string& what, const ZoneNumbers& numbers, Zone& zone, Problems& problems)
{
  const auto given = numbers.find(key.name);
  const std::vector<double*> targets = key.numbers(zone);
  if (given == numbers.end() || given->second.empty())
  {
    if (key.is_required)
      problems.push_back(what + " needs " + key.name + " (" + key.values + ")");
  }
  else if (given->second.size() != targets.size())
    problems.push_back(std::string(key.name) + " needs " +
                       (targets.size() == 1 ? "one number" : std::to_string(targets.size()) + " numbers") + " (" +
                       key.values + "), got " + std::to_string(given->second.size()));
  else
    for (std::size_t k = 0; k < targets.size(); ++k)
      *targets[k] = given->second[k];
}
}  // namespace

const std::vector<ZoneKey>& zoneKeys()
{
  static const std::vector<ZoneKey> keys = {
    { "center",
      "X Y Z",
      { ZoneKind::BOX, ZoneKind::CYLINDER, ZoneKind::SPHERE },
      true,
      [](Zone& zone) { return pointers(zone.pose.translation); } },
    { "point", "X Y Z", { ZoneKind::HALF_SPACE }, true, [](Zone& zone) { return pointers(zone.pose.translation); } },
    { "sides", "SX SY SZ", { ZoneKind::BOX }, true, [](Zone& zone) { return pointers(zone.sides); } },
    { "radius",
      "RADIUS",
      { ZoneKind::CYLINDER, ZoneKind::SPHERE },
      true,
      [](Zone& zone) { return std::vector<double*>{ &zone.radius }; } },
    { "height",
      "HEIGHT",
      { ZoneKind::CYLINDER },
      true,
      [](Zone& zone) { return std::vector<double*>{ &zone.height }; } },
    { "normal", "NX NY NZ", { ZoneKind::HALF_SPACE }, true, [](Zone& zone) { return pointers(zone.normal); } },
    { "orientation",
      "QX QY QZ QW",
      { ZoneKind::BOX, ZoneKind::CYLINDER },
      false,
      [](Zone& zone) {
        auto& q = zone.pose.orientation;
        return std::vector<double*>{ &q[0], &q[1], &q[2], &q[3] };
      } },
  };
  return keys;
}

Zone readZone(Zone::Use use, const std::string& kind, const std::string& name, const ZoneNumbers& numbers)
{
  Zone zone;
  zone.use = use;
  zone.kind = requireKind(kind);
  zone.name = name;
  Problems problems;
  for (const auto& given : numbers)
  {
    const auto known = [&](const ZoneKey& key) { return key.name == given.first && has(key, zone.kind); };
    if (std::none_of(zoneKeys().begin(), zoneKeys().end(), known))
      problems.push_back("'" + shortened(given.first, LONGEST_SHOWN) + "' is no key of a " + kind +
                         "; these are: kind, name, " + keysOf(zone.kind));
  }
  for (const ZoneKey& key : zoneKeys())
    if (has(key, zone.kind))
      readKey(key, "a " + kind, numbers, zone, problems);
  throwProblems(problems);
  return zone;
}

Zone readZone(Zone::Use use, const std::vector<std::string>& words)
{
  const ZoneKind kind = requireKind(words.empty() ? "" : words[0]);
  std::vector<double> given;
  for (std::size_t k = 1; k < words.size(); ++k)
    if (const auto number = parseNumber(words[k]))
      given.push_back(*number);
    else
      throw std::invalid_argument("'" + shortened(words[k], LONGEST_SHOWN) + "' is no number; give " + wordsOf(kind));
  ZoneNumbers numbers;
  std::size_t next = 0;
  for (const ZoneKey& key : zoneKeys())
    if (key.is_required && has(key, kind))
    {
      Zone zone;
      for (std::size_t count = key.numbers(zone).size(); count > 0; --count, ++next)
        if (next < given.size())
          numbers[key.name].push_back(given[next]);
    }
  if (next != given.size())
    throw std::invalid_argument("needs " + std::to_string(next) + " numbers, got " + std::to_string(given.size()) +
                                "; give " + wordsOf(kind));
  return readZone(use, words[0], "", numbers);
}

ZoneNumbers numbersOf(const Zone& zone)
{
  ZoneNumbers numbers;
  Zone own = zone, plain;
  for (const ZoneKey& key : zoneKeys())
  {
    if (!has(key, zone.kind))
      continue;
    std::vector<double> values;
    bool is_default = !key.is_required;
    const std::vector<double*> targets = key.numbers(own), defaults = key.numbers(plain);
    for (std::size_t k = 0; k < targets.size(); ++k)
    {
      values.push_back(*targets[k]);
      is_default = is_default && *targets[k] == *defaults[k];
    }
    if (!is_default)
      numbers[key.name] = values;
  }
  return numbers;
}

std::string zoneWords()
{
  std::vector<std::string> all;
  for (std::size_t kind = 0; kind < ZONE_KINDS.size(); ++kind)
    all.push_back(wordsOf(static_cast<ZoneKind>(kind)));
  return joined(all, ", ");
}
}  // namespace pkm_workspace
