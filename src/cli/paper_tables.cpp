// SPDX-License-Identifier: BSD-3-Clause
#include "paper_tables.h"

#include <cmath>

#include "pkm_workspace/interval/decimal.h"
#include "pkm_workspace/machine/catalogue.h"

namespace pkm_workspace
{
namespace cli
{
namespace
{
/// Relative: a tenth of what the last digits of tables 3 and 4 stand for.
constexpr double VOLUME_ACCURACY = 1e-3;

/// Studies of both machines, and regions of tables 1 and 2.
constexpr double PARTS = 2 + 4 + 11;

/// A number of the paper as it is printed, so that its last digit is known.
struct Printed
{
  std::string text;

  double unit() const
  {
    const std::size_t point = text.find('.');
    return point == std::string::npos ? 1.0 : std::pow(10.0, -static_cast<double>(text.size() - point - 1));
  }

  /// Whether it is right by one unit of its last digit.
  std::optional<bool> holds(const Interval& ours) const
  {
    const double value = std::stod(text);
    const Interval allowed = Interval(value) + Interval(-unit(), unit());
    if (ours.isSubsetOf(allowed))
      return true;
    return ours.intersects(allowed) ? std::nullopt : std::optional<bool>(false);
  }
};

PaperRow row(const std::string& place, const std::string& what, const Printed& paper, const Interval& ours)
{
  return { place, what, paper.text, describe(ours), ours, paper.holds(ours) };
}

/// R = 7/13 + lambda, r = 3/26, L = 1 m.
Machine uranesxAt(const Interval& lambda)
{
  return uranesx(Interval(7.0) / Interval(13.0) + lambda, Interval(3.0) / Interval(26.0));
}

class PaperTables
{
public:
  PaperTables(double accuracy, const Budget& budget, const Tell& tell) : tell_(tell)
  {
    query_.accuracy = accuracy;
    query_.budget = budget;
    query_.budget = query_.budget.inTurns(PARTS);
  }

  std::vector<PaperRow> run()
  {
    const Comparison cube = comparisonOf(orthoglide(), query_, VOLUME_ACCURACY, tell_);
    const Comparison square = comparisonOf(uranesxAt(0.0), query_, VOLUME_ACCURACY, tell_);
    addTable1();
    addTable2();
    addRanges("Orthoglide", cube, { "0.181" }, { "0.825" });
    addRanges("UraneSX", square, { "0.353" }, { "0.863" });
    addTable3("Orthoglide", cube, { "0.566" }, { "0.265" }, { "46.8" });
    addTable3("UraneSX", square, { "0.544" }, { "0.132" }, { "24.3" });
    addTable4("Orthoglide", cube, { { "1.55" }, { "1.28" }, { "2.13" } });
    addTable4("UraneSX", square, { { "1.96" }, { "1.69" }, { "4.12" } });
    addSingularities(cube, square);
    return rows_;
  }

private:
  LargestRegion largest(const Machine& machine, const ShapePtr& shape, double accuracy) const
  {
    tell_("largest " + shape->name() + " of " + machine.name());
    RegionQuery query = query_;
    query.shape = shape;
    query.accuracy = accuracy;
    return findLargestRegion(machine, query);
  }

  static Interval sizeOf(const LargestRegion& region) { return { region.size, region.size_upper_bound }; }

  /// Computation times of two machines do not contradict each other: no verdict on them.
  void addTable1()
  {
    struct Time
    {
      double accuracy;
      const char* seconds;
    };
    for (const Time& time : { Time{ 1e-2, "360" }, Time{ 1e-3, "150" }, Time{ 1e-4, "504" }, Time{ 1e-5, "900" } })
    {
      const LargestRegion region = largest(orthoglide(), makeCube(), time.accuracy);
      const std::string at = " for accuracy " + exact(time.accuracy) + " m";
      rows_.push_back(
          { "table 1", "seconds" + at, time.seconds, nearly(region.seconds, 2), Interval::empty(), std::nullopt });
      rows_.push_back(row("section 4.3", "edge of the cube [m]" + at, { "0.644" }, sizeOf(region)));
    }
  }

  void addTable2()
  {
    struct Square
    {
      const char* lambda;
      double x, y;
      const char* edge;
    };
    for (const Square& square :
         { Square{ "0.00", -0.0178, -0.0045, "0.510" }, Square{ "0.05", -0.0179, -0.0022, "0.470" },
           Square{ "0.10", -0.0225, -0.0031, "0.420" }, Square{ "0.15", -0.0245, -0.0018, "0.370" },
           Square{ "0.20", -0.0211, -0.0033, "0.320" } })
    {
      const Machine machine = uranesxAt(Interval(std::stod(square.lambda)));
      const std::string at = std::string(" for lambda = ") + square.lambda + " m";
      rows_.push_back(row("table 2", "edge of the square [m]" + at, { square.edge },
                          sizeOf(largest(machine, makeSquare(), query_.accuracy))));
      RegionQuery query = query_;
      query.shape = makeSquare();
      const Eigen::Vector3d center(square.x, square.y, machine.zero().z());
      const LargestRegion there = largestRegionAt(machine, query, center);
      rows_.push_back(row("table 2", "  around the paper's center", { square.edge }, sizeOf(there)));
    }
    const LargestRegion smaller = largest(uranesxAt(-0.035), makeSquare(), query_.accuracy);
    rows_.push_back({ "section 4.3", "edge of the square [m] for lambda = -0.035 m", "not satisfied",
                      describe(sizeOf(smaller)), sizeOf(smaller), verdict(smaller.size == 0.0, smaller.size > 0.0) });
  }

  static std::optional<bool> verdict(bool proved, bool refuted)
  {
    return proved ? std::optional<bool>(true) : refuted ? std::optional<bool>(false) : std::nullopt;
  }

  static Interval figure(const Comparison& study, const std::string& key, bool scaled)
  {
    for (const Figure& figure : figuresOf(study))
      if (figure.key == key)
        return scaled ? figure.scaled(study.region.size) : figure.value;
    return Interval::entire();
  }

  void addRanges(const std::string& machine, const Comparison& study, const Printed& across, const Printed& stroke)
  {
    rows_.push_back(row("section 4.4", machine + ", Delta f [m]", across, figure(study, "across", false)));
    rows_.push_back(row("section 4.4", machine + ", Delta rho [m]", stroke, figure(study, "stroke", false)));
  }

  void addTable3(const std::string& machine, const Comparison& study, const Printed& all, const Printed& cube,
                 const Printed& percent)
  {
    rows_.push_back(row("table 3", machine + ", workspace [m^3]", all, figure(study, "workspace_volume", false)));
    rows_.push_back(row("table 3", machine + ", cube [m^3]", cube, figure(study, "region_volume", false)));
    rows_.push_back(
        row("table 3", machine + ", ratio [%]", percent, Interval(100.0) * figure(study, "volume_ratio", false)));
  }

  void addTable4(const std::string& machine, const Comparison& study, const std::vector<Printed>& paper)
  {
    const char* const names[] = { ", strut [m]", ", Delta rho [m]", ", workspace [m^3]" };
    const char* const keys[] = { "strut", "stroke", "workspace_volume" };
    for (std::size_t k = 0; k < 3; ++k)
      rows_.push_back(
          row("table 4", machine + names[k] + " for a cube of edge 1 m", paper[k], figure(study, keys[k], true)));
  }

  void addSingularity(const std::string& what, bool exists, const SingularityAnswer& answer)
  {
    using Status = SingularityAnswer::Status;
    const Status expected = exists ? Status::PROVED : Status::NONE;
    rows_.push_back({ "section 4.3", what, exists ? "some" : "none", verdictOn(answer), Interval::empty(),
                      verdict(answer.status == expected, answer.status != Status::UNDECIDED) });
  }

  void addSingularities(const Comparison& orthoglide, const Comparison& uranesx)
  {
    addSingularity("Orthoglide, parallel singularities within the strokes", false, orthoglide.in_ranges.parallel);
    addSingularity("Orthoglide, serial ones", false, least(orthoglide.in_ranges.serial));
    addSingularity("UraneSX, parallel singularities within the strokes", false, uranesx.in_ranges.parallel);
    addSingularity("UraneSX, serial ones", true, least(uranesx.in_ranges.serial));
  }

  const Tell& tell_;
  RegionQuery query_;
  std::vector<PaperRow> rows_;
};
}  // namespace

std::vector<PaperRow> paperRows(double accuracy, const Budget& budget, const Tell& tell)
{
  return PaperTables(accuracy, budget, tell).run();
}
}  // namespace cli
}  // namespace pkm_workspace
