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
  throw std::invalid_argument("'" + shortened(name, LONGEST_SHOWN) + "' is not a kind of zone; these are: " +
                              joined({ ZONE_KINDS.begin(), ZONE_KINDS.end() }, ", "));
}

const char* nameOf(const ZoneKey& key, ZoneNames names)
{
  return names == ZoneNames::KEYS ? key.name : key.field;
}

std::string namesOf(ZoneKind kind, ZoneNames names)
{
  std::vector<std::string> all;
  for (const ZoneKey& key : zoneKeys())
    if (has(key, kind))
      all.emplace_back(nameOf(key, names));
  return joined(all, ", ");
}

/// Why a zone of this kind is not given that.
std::string strange(const std::string& name, const std::string& kind, ZoneNames names)
{
  const ZoneKind has = requireKind(kind);
  const auto key =
      std::find_if(zoneKeys().begin(), zoneKeys().end(), [&name](const ZoneKey& known) { return known.name == name; });
  if (names == ZoneNames::FIELDS && key != zoneKeys().end())
    return std::string(key->field) + " must be 0: a " + kind + " has only name, " + namesOf(has, names);
  return "unknown key '" + shortened(name, LONGEST_SHOWN) + "' in a " + kind + "; its keys are: kind, name, " +
         namesOf(has, names);
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

void readKey(const ZoneKey& key, const std::string& what, const ZoneNumbers& numbers, ZoneNames names, Zone& zone,
             Problems& problems)
{
  const auto given = numbers.find(key.name);
  const std::vector<double*> targets = key.numbers(zone);
  if (given == numbers.end() || given->second.empty())
  {
    if (key.is_required)
      problems.push_back(what + " needs " + nameOf(key, names) + " (" + key.values + ")");
  }
  else if (given->second.size() != targets.size())
    problems.push_back(std::string(nameOf(key, names)) + " needs " +
                       (targets.size() == 1 ? "one number" : std::to_string(targets.size()) + " numbers") + " (" +
                       key.values + "), got " + std::to_string(given->second.size()));
  else
    for (std::size_t k = 0; k < targets.size(); ++k)
      *targets[k] = given->second[k];
}
}  // namespace

const std::vector<ZoneKey>& zoneKeys()
{
  using Kind = ZoneKind;
  const auto place = [](Zone& zone) { return pointers(zone.pose.translation); };
  const auto sides = [](Zone& zone) { return pointers(zone.sides); };
  const auto radius = [](Zone& zone) { return std::vector<double*>{ &zone.radius }; };
  const auto height = [](Zone& zone) { return std::vector<double*>{ &zone.height }; };
  const auto normal = [](Zone& zone) { return pointers(zone.normal); };
  const auto turn = [](Zone& zone) {
    auto& q = zone.pose.orientation;
    return std::vector<double*>{ &q[0], &q[1], &q[2], &q[3] };
  };
  static const std::vector<ZoneKey> keys = {
    { "center", "pose.position", "X Y Z", { Kind::BOX, Kind::CYLINDER, Kind::SPHERE }, true, place },
    { "point", "pose.position", "X Y Z", { Kind::HALF_SPACE }, true, place },
    { "sides", "sides", "SX SY SZ", { Kind::BOX }, true, sides },
    { "radius", "radius", "RADIUS", { Kind::CYLINDER, Kind::SPHERE }, true, radius },
    { "height", "height", "HEIGHT", { Kind::CYLINDER }, true, height },
    { "normal", "normal", "NX NY NZ", { Kind::HALF_SPACE }, true, normal },
    { "orientation", "pose.orientation", "QX QY QZ QW", { Kind::BOX, Kind::CYLINDER }, false, turn },
  };
  return keys;
}

Zone readZone(Zone::Use use, const std::string& kind, const std::string& name, const ZoneNumbers& numbers,
              ZoneNames names)
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
      problems.push_back(strange(given.first, kind, names));
  }
  for (const ZoneKey& key : zoneKeys())
    if (has(key, zone.kind))
      readKey(key, "a " + kind, numbers, names, zone, problems);
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
      throw std::invalid_argument("'" + shortened(words[k], LONGEST_SHOWN) + "' is not a number; give " +
                                  wordsOf(kind));
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
