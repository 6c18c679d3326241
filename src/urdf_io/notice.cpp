// SPDX-License-Identifier: BSD-3-Clause
#include "notice.h"

#include <algorithm>
#include <utility>

namespace pkm_workspace
{
namespace urdf_io
{
namespace
{
/// Something that several have in common, with these.
template <class Member>
using Groups = std::vector<std::pair<std::string, std::vector<Member>>>;

template <class Member>
void put(const std::string& key, const Member& member, Groups<Member>& groups)
{
  const auto same = [&key](const auto& group) { return group.first == key; };
  const auto found = std::find_if(groups.begin(), groups.end(), same);
  if (found != groups.end())
    found->second.push_back(member);
  else
    groups.push_back({ key, { member } });
}

std::string valuesOf(const std::vector<Notice>& notices)
{
  Groups<std::string> values;
  for (const Notice& notice : notices)
    put(notice.value, notice.about, values);
  std::string list;
  for (const auto& value : values)
    list += (list.empty() ? "" : ", ") +
            (value.first.empty() ? listOf(value.second) : value.first + " (" + listOf(value.second) + ")");
  return list;
}
}  // namespace

std::string listOf(const std::vector<std::string>& names, const std::string& none)
{
  std::string list;
  for (const std::string& name : names)
    list += (list.empty() ? "'" : ", '") + name + "'";
  return list.empty() ? none : list;
}

std::vector<std::string> sentencesOf(const std::vector<Notice>& notices)
{
  Groups<Notice> kinds;
  for (const Notice& notice : notices)
    put(notice.kind, notice, kinds);
  std::vector<std::string> sentences;
  for (const auto& kind : kinds)
  {
    const bool single = kind.second.size() == 1 || kind.second[0].about.empty();
    sentences.push_back(single ? kind.second[0].one : kind.first + ": " + valuesOf(kind.second));
  }
  return sentences;
}
}  // namespace urdf_io
}  // namespace pkm_workspace
