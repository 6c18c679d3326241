// SPDX-License-Identifier: BSD-3-Clause
// What is asked for and what was found, in one line each.
#include "pkm_workspace/interval/decimal.h"
#include "pkm_workspace/interval/text_stream.h"
#include "pkm_workspace/report/largest_sentence.h"
#include "pkm_workspace/ros/conversions.h"

namespace pkm_workspace
{
namespace
{
const Eigen::IOFormat POINT_TEXT(Eigen::StreamPrecision, Eigen::DontAlignCols, ", ", ", ", "", "", "(", ")");
}  // namespace

std::string describe(const RegionQuery& query)
{
  TextStream text;
  text << "largest " << query.shape->name();
  if (query.ratio)
    text << ", radius " << query.ratio->lower << " to " << query.ratio->upper << " times its height";
  if (query.turns())
    text << ", turned about the vertical";
  if (query.base_z)
    text << ", standing on z = " << *query.base_z << " m";
  if (query.hasSearchBox())
    text << (query.base_z ? ", the middle of its base from " : ", its center from ")
         << query.search_box->lower.format(POINT_TEXT) << " to " << query.search_box->upper.format(POINT_TEXT) << " m";
  text << ", " << describe(query.criterion) << ", accuracy " << query.accuracy << " m, within "
       << query.budget.time_limit << " s";
  return text.str();
}

std::string summary(const Answer& answer)
{
  const LargestRegion& region = answer.region;
  TextStream text;
  if (region.size > 0.0)
  {
    text << region.shape->name() << " at " << region.center.format(POINT_TEXT) << " m of frame '"
         << answer.question.in.frame << "', ";
    if (region.angle)
      text << "turned by " << *region.angle << " rad, ";
    text << region.shape->sizeMeaning() << ' ' << region.size << ", dimensions";
    for (const double length : region.shape->dimensions(region.size))
      text << ' ' << length;
    text << " m";
    if (region.ratio)
      text << ", volume " << region.volume << " m^3";
    text << ". ";
  }
  text << describe(region, *answer.question.in.machine, answer.question.query) << ' '
       << region.boxes + region.verification_boxes << " boxes, " << nearly(region.seconds, 3) << " s";
  return text.str();
}
}  // namespace pkm_workspace
