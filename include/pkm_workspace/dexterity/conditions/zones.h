// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "pkm_workspace/dexterity/condition.h"
#include "pkm_workspace/dexterity/criterion.h"
#include "pkm_workspace/dexterity/zone_forms.h"
#include "pkm_workspace/dexterity/zone_separation.h"

namespace pkm_workspace
{
/// The tool keeps within and out of zones: all depths are not negative, or one of them is not positive.
template <class Real>
class Zones
{
public:
  static constexpr bool BOUNDS_FACTORS = false;
  static std::optional<Interval> steepest(const Machine& /*machine*/, const Criterion& /*criterion*/)
  {
    return std::nullopt;
  }
  template <class At>
  static void tellLimits(At& at)
  {
    const Criterion& criterion = at.criterion();
    for (std::size_t k = 0; k < criterion.zones.size(); ++k)
    {
      const Zone& zone = criterion.zones[k];
      const Interval value = clearance(enclosed(zone, criterion.tool_radius), at.point());
      at.tell({ kindOf(zone.use), -1, value, 0.0, value, static_cast<int>(k), title(zone) });
    }
  }

  Zones(const Machine& /*machine*/, const Criterion& criterion)
  {
    for (const Zone& zone : criterion.zones)
      add(zoneOfForms<Real>(enclosed(zone, criterion.tool_radius)));
  }
  template <class Other>
  explicit Zones(const Zones<Other>& other)
  {
    for (const ZoneOfForms<Other>& zone : other.forms_)
      add(zoneOfForms<Real>(zone));
  }

  template <class Place, class Visitor>
  void visit(const Place& place, Visitor& visitor) const
  {
    const auto keepIn = [&](const AffineForm<Real>& depth) { visitor.scalar({ ConditionKind::KEEP_IN }, depth, 1); };
    const auto keepOut = [&](const AlternativeForms<Real>& heights, const auto& separating) {
      visitor.anyOf({ ConditionKind::KEEP_OUT }, heights, 1, separating);
    };
    eachZone(place.box, keepIn, keepOut);
  }

  template <class Place, class Visitor>
  void visitScalar(const Place& place, Visitor& visitor) const
  {
    const auto keepIn = [&](const AffineForm<Real>& depth) { visitor.scalar({ ConditionKind::KEEP_IN }, depth, 1); };
    const auto keepOut = [&](const AlternativeForms<Real>& heights, const auto& /*separating*/) {
      visitor.scalar({ ConditionKind::KEEP_OUT }, heights.largest(), 1);
    };
    eachZone(place.box, keepIn, keepOut);
  }

  Real margin(const NearPlace<Real>& place) const
  {
    using std::max;
    using std::min;
    Real least(NO_MARGIN);
    for (const PlainZone<Real>& zone : numbers_)
    {
      PlainVector<Real> u;
      mapOffset(zone.turn, zone.center, place.p, u);
      const Real clearance = clearanceOf(
          zone, u, [](const Real& a, const Real& b) { return min(a, b); },
          [](const Real& a, const Real& b) { return max(a, b); });
      least = min(least, clearance * place.per_length);
    }
    return least;
  }

private:
  template <class>
  friend class Zones;

  static ConditionKind kindOf(Zone::Use use)
  {
    return use == Zone::Use::KEEP_IN ? ConditionKind::KEEP_IN : ConditionKind::KEEP_OUT;
  }

  static bool isPositive(const AffineForm<Real>& form) { return !any(!(form.lower() > Real(0))); }

  /// What holds on all of the box is not told.
  /// @param keep_in takes the depth beneath a surface @param keep_out takes the heights above all of a zone's surfaces,
  /// and what makes the form of a plane between the box and the zone
  template <class Domain, class KeepIn, class KeepOut>
  void eachZone(const Domain& box, const KeepIn& keep_in, const KeepOut& keep_out) const
  {
    for (std::size_t k = 0; k < forms_.size(); ++k)
    {
      const ZoneOfForms<Real>& zone = forms_[k];
      AffineVector<Real> offset;
      mapOffset(zone.turn, zone.center, box, offset);
      const std::array<AffineForm<Real>, 3> u = { component(offset, 0), component(offset, 1), component(offset, 2) };
      AlternativeForms<Real> heights;
      bool holds = false;
      eachDepth(zone, u, [&](const AffineForm<Real>& depth) {
        holds = holds || isPositive(-depth);
        if (zone.use == Zone::Use::KEEP_OUT)
          heights.add(-depth);
        else if (!isPositive(depth))
          keep_in(depth);
      });
      if (zone.use == Zone::Use::KEEP_IN || holds)
        continue;
      keep_out(heights, [&] { return separatingForm(zone, numbers_[k], u); });
    }
  }

  void add(const ZoneOfForms<Real>& zone)
  {
    forms_.push_back(zone);
    numbers_.push_back(plainZone(zone));
  }

  std::vector<ZoneOfForms<Real>> forms_;
  std::vector<PlainZone<Real>> numbers_;
};
}  // namespace pkm_workspace
