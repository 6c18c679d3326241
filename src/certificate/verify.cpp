// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/certificate/verify.h"

#include <set>

#include "checked_body.h"
#include "pkm_workspace/interval/decimal.h"

namespace pkm_workspace
{
namespace
{
using namespace checking;

/// @param is_twofold is set where an object has a member twice, of which others may read the other one
Json parsed(const std::string& text, bool& is_twofold)
{
  std::vector<std::set<std::string>> members;
  return Json::parse(
      text,
      [&](int, Json::parse_event_t event, const Json& value) {
        if (event == Json::parse_event_t::object_start)
          members.emplace_back();
        else if (event == Json::parse_event_t::object_end)
          members.pop_back();
        else if (event == Json::parse_event_t::key)
          is_twofold = !members.back().insert(value.get<std::string>()).second || is_twofold;
        return true;
      },
      false);
}

/// The person who waits wants no more.
class Stopped : public std::exception
{
};

void verifyBodies(const Json& json, const CheckedClaims& claims, const std::function<void()>& leaf,
                  const std::int64_t& leaves, Verification& result)
{
  const CheckedBody body(json.at("body"));
  const auto boxes = [&leaves](std::int64_t before) { return " (boxes: " + std::to_string(leaves - before) + ")"; };
  if (!json.at("region").is_null())
  {
    RegionCheck(claims, body, json.at("region")).run(leaf);
    result.verified.push_back("every point of the region satisfies the criterion" + boxes(0));
  }
  const std::int64_t before = leaves;
  const Json& bound = json.at("bound");
  if (bound.is_null())
    return;
  BoundCheck(claims, body, bound).run(leaf);
  const std::string where = bound.at("search_box").is_null() ? "" : " with its center in the search box";
  result.verified.push_back("no region larger than " + exact(numberOf(bound.at("size"))) + where + " satisfies it" +
                            boxes(before));
}

void verify(const Json& json, const VerificationProgress& progress, Verification& result)
{
  expect(json, "the certificate",
         { "format", "version", "written_by", "geometry_hash", "machine", "criterion", "body", "region", "bound",
           "boxes", "path" });
  need(json.at("format") == "pkm_workspace certificate" && json.at("version") == 1, "another format or version");
  const CheckedClaims claims(json);
  const auto isClaimed = [&](const char* name) { return !json.at(name).is_null(); };
  need(isClaimed("region") || isClaimed("bound") || isClaimed("boxes") || isClaimed("path"), "nothing is claimed");
  std::int64_t leaves = 0;
  const auto leaf = [&] {
    if (progress && !progress(++leaves))
      throw Stopped();
  };
  if (isClaimed("region") || isClaimed("bound"))
    verifyBodies(json, claims, leaf, leaves, result);
  if (isClaimed("boxes"))
    result.verified.push_back(BoxesCheck(claims, json.at("boxes")).run(leaf));
  if (isClaimed("path"))
    result.verified.push_back(checkPath(claims, json.at("path"), leaf));
}
}  // namespace

Verification verifyCertificate(const std::string& text, const VerificationProgress& progress)
{
  bool is_twofold = false;
  const Json json = parsed(text, is_twofold);
  if (json.is_discarded())
    throw std::invalid_argument("not a certificate, which is a JSON object: pkm largest --certificate FILE writes one");
  if (is_twofold)
    return { {}, "a member that is there twice" };
  Verification result;
  try
  {
    verify(json, progress, result);
  }
  catch (const Refused& refused)
  {
    result.refused = refused.what();
  }
  catch (const Stopped&)
  {
    result.refused = "stopped before the end";
  }
  catch (const Json::exception& error)
  {
    result.refused = std::string("not a certificate: ") + error.what();
  }
  catch (const std::out_of_range&)
  {
    result.refused = "a number that counts nothing";
  }
  return result;
}
}  // namespace pkm_workspace
