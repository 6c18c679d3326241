// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <initializer_list>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>

#include "jet.h"

namespace pkm_workspace
{
namespace checking
{
// What a certificate is about, read and written down anew (docs/certificate.md). Nothing here is shared with the
// search.

using Json = nlohmann::json;
using Numbers = std::array<double, 3>;

/// The first thing that does not hold.
class Refused : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

inline void need(bool holds, const std::string& what)
{
  if (!holds)
    throw Refused(what);
}

/// Refuses an object that has other members than these: whatever is not understood may change what is claimed.
void expect(const Json& object, const std::string& what, std::initializer_list<const char*> members);
double numberOf(const Json& json);
/// A number, or an enclosure [lower, upper] of one.
Ball ballOf(const Json& json);
Numbers numbersOf(const Json& json);
Vector vectorOf(const Json& json);

struct Cube
{
  Numbers lower;
  Numbers upper;
};
Cube cubeOf(const Json& json);
std::string textOf(const Cube& box);
/// A number below the count.
std::size_t indexOf(const Json& json, std::size_t count);
/// A single point.
JetVector pointAt(const Numbers& p);
/// The point that delta stands for in a box.
JetVector pointsOf(const Cube& box);
}  // namespace checking
}  // namespace pkm_workspace
