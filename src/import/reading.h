// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "decimal_number.h"
#include "pkm_workspace/common/problems.h"
#include "pkm_workspace/import/firmware.h"
#include "source_lines.h"

namespace pkm_workspace
{
namespace firmware
{
/// A value of a file, by a key that is written only once.
struct Entry
{
  SourcePlace place;
  std::string key;
  std::string text;
};

/// What a number may be, and what it is in metres, degrees or as a share.
struct Quantity
{
  const char* unit;  ///< of the file
  long least;        ///< in that unit
  long most;
  long factor;  ///< from that unit to the other one: factor * 10^exponent
  int exponent;
  const char* si;  ///< metres, degrees, a share
};

constexpr Quantity MILLIMETRES = {
  "mm", 1, 100000, 1, -3, "m"
};  ///< a length; not below 1, so that metres do not pass
constexpr Quantity SIGNED_MILLIMETRES = { "mm", -100000, 100000, 1, -3, "m" };  ///< a height
constexpr Quantity TRIM_MILLIMETRES = { "mm", -100, 100, 1, -3, "m" };          ///< added to a length or a height
constexpr Quantity DEGREES = { "degrees", -360, 360, 1, 0, "degrees" };
constexpr Quantity TRIM_DEGREES = { "degrees", -30, 30, 1, 0, "degrees" };  ///< added to a direction
constexpr Quantity PERCENT = { "%", -20, 20, 1, -2, "m for each metre" };   ///< of a slope

/// What one format finds in a text: all problems, what it took and what it left aside.
class Reading
{
public:
  Problems problems;
  std::vector<TakenValue> taken;
  std::vector<LeftAside> left_aside;
  /// The number that a text stands for.
  std::function<std::optional<Decimal>(const std::string& text)> evaluate = Decimal::parse;
  /// How numbers are written: "a decimal number without its unit".
  std::string number_words = "a decimal number without its unit";

  void add(const Entry& entry) { entries_.push_back(entry); }
  const std::vector<Entry>& entries() const { return entries_; }
  bool has(const std::string& key) const;
  /// The entry of this key, or nothing; one that is there twice is a problem. It counts as seen.
  const Entry* find(const std::string& key);

  /// The number of this key in metres, degrees or as a share; nothing where it is not there or is a problem.
  /// @param what the sentence's subject: "arm of stepper_a"
  std::optional<Decimal> value(const std::string& key, const std::string& what, const Quantity& quantity);
  /// The same where a machine needs it. @param remedy what to do where it is missing
  std::optional<Decimal> needed(const std::string& key, const std::string& what, const Quantity& quantity,
                                const std::string& remedy);
  /// The same, or the firmware's default where it is not there. @param otherwise in metres or degrees
  std::optional<Decimal> valueOr(const std::string& key, const std::string& what, const Quantity& quantity,
                                 const Decimal& otherwise);
  /// A number within the range, from the file's unit; the problem is told otherwise.
  std::optional<Decimal> inRange(const Entry& entry, const std::string& text, const Quantity& quantity);

  void take(const Entry& entry, const std::string& meaning);
  /// Tells a default of the firmware. @param value in metres or degrees @return the value
  Decimal assume(const std::string& key, const std::string& what, const Decimal& value, const std::string& unit = "m");
  void leave(const Entry& entry, const std::string& reason);
  void miss(const std::string& key, const std::string& remedy);
  template <class... Parts>
  void refuse(const SourcePlace& place, const Parts&... parts)
  {
    complain(problems, toText(place), ": ", parts...);
  }
  /// Leaves aside what nobody asked for.
  void leaveRest(const std::function<std::string(const Entry&)>& reason);
  /// Leaves aside what nobody asked for of the keys that @p kind gives the same name; each such name once.
  void leaveKinds(const std::function<std::string(const Entry&)>& kind, const std::string& reason);

  std::string file;  ///< that was given

private:
  std::vector<Entry> entries_;
  std::set<std::string> seen_;
};

/// "0.269 m".
std::string measure(const Decimal& value, const std::string& unit);
}  // namespace firmware
}  // namespace pkm_workspace
