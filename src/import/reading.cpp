// SPDX-License-Identifier: BSD-3-Clause
#include "reading.h"

#include <algorithm>
#include <map>

#include "pkm_workspace/interval/decimal.h"

namespace pkm_workspace
{
namespace firmware
{
std::string measure(const Decimal& value, const std::string& unit)
{
  return exact(value.nearest()) + " " + unit;
}

bool Reading::has(const std::string& key) const
{
  return std::any_of(entries_.begin(), entries_.end(), [&](const Entry& entry) { return entry.key == key; });
}

const Entry* Reading::find(const std::string& key)
{
  const Entry* found = nullptr;
  for (const Entry& entry : entries_)
  {
    if (entry.key != key)
      continue;
    if (found != nullptr && seen_.count(key) == 0)
      refuse(entry.place, key, " is given twice: ", quoted(found->text), " in ", toText(found->place), " and ",
             quoted(entry.text), " here; keep one of them");
    found = found != nullptr ? found : &entry;
  }
  if (found != nullptr)
    seen_.insert(key);
  return found;
}

std::optional<Decimal> Reading::inRange(const Entry& entry, const std::string& text, const Quantity& quantity)
{
  const std::string range = "from " + measure(quantity.least, "to ") + measure(quantity.most, quantity.unit);
  const std::optional<Decimal> number = evaluate(text);
  if (!number)
    refuse(entry.place, entry.key, " = ", quoted(text), " is not a number; allowed: ", number_words, ", ", range);
  else if (*number < Decimal(quantity.least) || Decimal(quantity.most) < *number)
    refuse(entry.place, entry.key, " = ", quoted(text), " ", quantity.unit, " is out of range; allowed: ", range,
           "; check its unit and its point");
  else
    return *number * Decimal(quantity.factor, quantity.exponent);
  return std::nullopt;
}

std::optional<Decimal> Reading::value(const std::string& key, const std::string& what, const Quantity& quantity)
{
  const Entry* const entry = find(key);
  if (entry == nullptr)
    return std::nullopt;
  const std::optional<Decimal> number = inRange(*entry, entry->text, quantity);
  if (number)
    take(*entry, what + ": " + measure(*number, quantity.si));
  return number;
}

std::optional<Decimal> Reading::needed(const std::string& key, const std::string& what, const Quantity& quantity,
                                       const std::string& remedy)
{
  if (!has(key))
    miss(key, remedy);
  return value(key, what, quantity);
}

std::optional<Decimal> Reading::valueOr(const std::string& key, const std::string& what, const Quantity& quantity,
                                        const Decimal& otherwise)
{
  return has(key) ? value(key, what, quantity) : assume(key, what, otherwise, quantity.si);
}

void Reading::take(const Entry& entry, const std::string& meaning)
{
  taken.push_back({ entry.place, entry.key, entry.text, meaning });
}

Decimal Reading::assume(const std::string& key, const std::string& what, const Decimal& value, const std::string& unit)
{
  SourcePlace nowhere;
  nowhere.file = file;
  take({ nowhere, key, "not set" }, what + ": " + measure(value, unit) + ", the default");
  return value;
}

void Reading::leave(const Entry& entry, const std::string& reason)
{
  seen_.insert(entry.key);
  left_aside.push_back({ entry.place, entry.key, reason });
}

void Reading::miss(const std::string& key, const std::string& remedy)
{
  complain(problems, file, ": ", key, " is missing; ", remedy);
}

void Reading::leaveRest(const std::function<std::string(const Entry&)>& reason)
{
  for (const Entry& entry : entries_)
    if (seen_.count(entry.key) == 0)
      left_aside.push_back({ entry.place, entry.key, reason(entry) });
}

void Reading::leaveKinds(const std::function<std::string(const Entry&)>& kind, const std::string& reason)
{
  std::map<std::string, std::size_t> counts;
  std::vector<Entry> firsts;
  for (const Entry& entry : entries_)
  {
    const std::string name = seen_.count(entry.key) == 0 ? kind(entry) : "";
    if (name.empty())
      continue;
    if (counts[name]++ == 0)
      firsts.push_back({ entry.place, name, "" });
  }
  for (const Entry& first : firsts)
  {
    const std::size_t count = counts[first.key];
    left_aside.push_back(
        { first.place, first.key, reason + (count > 1 ? " (" + std::to_string(count) + " values)" : "") });
  }
  for (const Entry& entry : entries_)
    if (!kind(entry).empty())
      seen_.insert(entry.key);
}
}  // namespace firmware
}  // namespace pkm_workspace
