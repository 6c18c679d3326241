# SPDX-License-Identifier: BSD-3-Clause
"""Deliberate unsoundnesses, and the quick test that fails with each: see scripts/mutate."""

from checker_mutations import CHECKER_MUTATIONS
from mutation import Gtest, Mutation

INTERVAL = "include/pkm_workspace/interval/"
MACHINE = "include/pkm_workspace/machine/"
DEXTERITY = "include/pkm_workspace/dexterity/"
# What looks at boxes, with two lanes: wider kernels are left out where this one is compiled anew.
KERNEL = ("src/dexterity/box_kernel.cpp", "src/dexterity/verdict.cpp")


def in_header(name, sources, program="interval_test"):
    """The test of a header, which is compiled with the mutation."""
    return Gtest(program, name, tuple("test/%s.cpp" % source for source in sources))


OPERATIONS = Gtest("interval_test", "IntervalContainment.operationsHoldTheResultsForAllMembers")
AFFINE_PRODUCTS = in_header("AffineFormContainment.sumsAndProductsHoldThoseOfAllMembers", ["interval/affine_form_test"])
BALLS = in_header("Ball.hasWhatItsMembersBecome", ["interval/ball_test"])
PENCILS = in_header("PencilBoundsContainment.boundsHoldTheEigenvaluesOfEveryMember", ["interval/pencil_bounds_test"])
LEGS = in_header("LegForms.holdTheLegsThatAreClosedByTriangles", ["machine/leg_forms_test"], "machine_test")
LIMITS = Gtest("dexterity_test", "BoxTest.verdictsHoldWithJointLimits")
MACHINES = Gtest("dexterity_test", "Tolerances.everyMachineIsGoodInside")
BOXES = Gtest("region_test", "Containment.agreesWithTheOracleOnRandomBoxes")
COMPONENTS = Gtest("paving_test", "Components.areThoseOfAllPairsOfBoxes")

NUMBERS = [
    Mutation("sum_rounded_down", "src/interval/interval.cpp", "rounding::add(x.upper(), y.upper()).upper",
             "rounding::add(x.upper(), y.upper()).lower", "the upper end of a sum is rounded down", OPERATIONS),
    Mutation("product_of_wrong_ends", "src/interval/interval.cpp",
             "const double for_lower = x.lower() >= 0.0 ? y.lower() : y.upper();",
             "const double for_lower = x.lower() >= 0.0 ? y.upper() : y.lower();",
             "the lower end of a product is made of the wrong ends", OPERATIONS),
    Mutation("square_across_zero", "src/interval/interval.cpp", "return contains(0.0) ? 0.0 : std::min(",
             "return std::min(", "squares of what contains 0 begin above 0", OPERATIONS),
    Mutation("root_rounded_down", "src/interval/interval.cpp", "rounding::squareRoot(x.upper()).upper",
             "rounding::squareRoot(x.upper()).lower", "the upper end of a square root is rounded down", OPERATIONS),
    Mutation("angle_rounded_to_nearest", "src/interval/angle.cpp", "rounding::SOUND ? mode : MPFR_RNDN",
             "MPFR_RNDN", "angles are rounded to the nearest double instead of outward",
             Gtest("interval_test", "IntervalContainment.anglesHoldThoseOfAllDirections")),
    Mutation("affine_sum_unrounded", INTERVAL + "affine_form.h",
             "sum.radius = affine::widened(a.radius + b.radius, a.magnitude() + b.magnitude(), 4);",
             "sum.radius = a.radius + b.radius;", "sums of affine forms lose their roundings", AFFINE_PRODUCTS),
    Mutation("affine_product_mixed", INTERVAL + "affine_form.h",
             "mixed = mixed + abs(a.gradient[j] * b.gradient[k] + a.gradient[k] * b.gradient[j]);",
             "mixed = mixed + abs(a.gradient[j] * b.gradient[k]);",
             "products of affine forms lose half of their mixed second order", AFFINE_PRODUCTS),
    Mutation("affine_root_chord", INTERVAL + "affine_form.h",
             "root.radius = affine::widened(a.radius * slope + half_gap,",
             "root.radius = affine::widened(a.radius * slope,", "the square root is taken for its chord",
             in_header("AffineFormContainment.squareRootHoldsThoseOfAllMembersAboveTheFloor",
                       ["interval/affine_form_test"])),
    Mutation("affine_inverse_chord", INTERVAL + "affine_form.h",
             "inverse.radius = affine::widened(a.radius * slope + half_gap,",
             "inverse.radius = affine::widened(a.radius * slope,", "the inverse is taken for its chord",
             in_header("AffineFormContainment.inverseHoldsThoseOfAllMembersOfPositiveForms",
                       ["interval/affine_form_test"])),
    Mutation("affine_maximum_chord", INTERVAL + "affine_form.h",
             "largest.radius = affine::widened(largest.radius + half_gap,",
             "largest.radius = affine::widened(largest.radius,", "the larger of two forms is taken for a mixture",
             in_header("AffineFormContainment.maximumHoldsTheLargerOfAllMembers", ["interval/affine_form_test"])),
    Mutation("quadratic_product_third_order", INTERVAL + "quadratic_form.h",
             "affine::widened(result.linear.radius + bend.off * b.swing() + b.radius * most,",
             "affine::widened(result.linear.radius + b.radius * most,",
             "products of quadratic and affine forms lose their third order",
             in_header("QuadraticFormContainment.operationsHoldThoseOfAllMembers", ["interval/quadratic_form_test"])),
    Mutation("quadratic_vectors_fourth_order", INTERVAL + "quadratic_form.h", "bend_u * bend_v + ", "",
             "products of quadratic vectors lose their fourth order",
             in_header("QuadraticFormContainment.vectorsHoldThoseOfAllMembers", ["interval/quadratic_form_test"])),
    Mutation("pencil_radii", INTERVAL + "pencil_bounds.h",
             "return least - (max(m[i].radius, m[j].radius) + m[k].radius) - noise(magnitude);",
             "return least - noise(magnitude);", "the middle eigenvalue is bounded without the radii of the matrix",
             PENCILS),
    Mutation("pencil_flipped_divisor", INTERVAL + "pencil_bounds.h", "select(bound > Real(0), largest, least)",
             "select(bound > Real(0), least, largest)",
             "steps to an eigenvalue are divided by the wrong bound of the other matrix", PENCILS),
    Mutation("definite_at_seven_corners", INTERVAL + "definiteness.h",
             "corner[k][4 * x + 2 * y + 1] = along_xy + m[k].gradient[2];",
             "corner[k][4 * x + 2 * y + 1] = along_xy + (x + y < 2 ? Real(1) : Real(0)) * m[k].gradient[2];",
             "one corner of the cube is not held against definiteness",
             in_header("Definiteness.oneBadCornerIsEnough", ["interval/definiteness_test"])),
    Mutation("ball_product", INTERVAL + "ball.h", "a.radius_ * b.most())", "a.radius_ * magnitude(b.middle_))",
             "products of balls lose the product of their radii", BALLS),
    Mutation("ball_rounding", INTERVAL + "ball.h", "up(radius_ + ROUNDOFF * magnitude(middle_))) : *this;",
             "radius_) : *this;", "middles of balls lose their roundings", BALLS),
    Mutation("share_without_error", "src/interval/cube_cut.cpp", "std::min(1.0, std::max(0.0, share + slack)) };",
             "std::min(1.0, std::max(0.0, share)) };", "shares of a cut cube lose their roundings",
             Gtest("interval_test", "CubeCutContainment.shareIsTheSumOfTheSections")),
    Mutation("share_by_inner_plane", "src/interval/cube_cut.cpp",
             "upper = std::min(upper, shareOf(cuts[k].outer, cuts[k].gradient).upper);",
             "upper = std::min(upper, shareOf(cuts[k].inner, cuts[k].gradient).upper);",
             "the share that is left is bounded from above by where conditions hold for sure",
             Gtest("interval_test", "CubeCut.shareWithinSeveralPlanesHoldsThePointsThatAre")),
    Mutation("part_unrounded", INTERVAL + "cube_cut.h", "lower - ROUNDING * lower - least", "lower",
             "parts of volumes are not rounded down",
             in_header("CubeCutContainment.partsOfMeasuresHoldTheExactProduct", ["interval/cube_cut_test"])),
]

MACHINES_AND_LEGS = [
    Mutation("strut_joint_sign", MACHINE + "sliding_strut_forms.h",
             "return dotOffset(strut.along, strut.center, p) - state.drive;",
             "return dotOffset(strut.along, strut.center, p) + state.drive;",
             "joint values of sliding struts are those of the other working mode", LIMITS, KERNEL),
    Mutation("strut_row_sign", MACHINE + "sliding_strut_forms.h", "addAlong(state.row, state.drive, strut.axis);",
             "addAlong(state.row, -state.drive, strut.axis);", "sliding struts point the wrong way along their rails",
             BOXES, KERNEL),
    Mutation("telescope_joint_sign", MACHINE + "telescopic_strut_forms.h", "return state.drive + -strut.length;",
             "return state.drive + strut.length;", "joint values of struts of variable length count the wrong way",
             LEGS),
    Mutation("crank_tip_third_order", MACHINE + "crank_over_box.h",
             "widen(sine, most * most_square * (Real(0.5) + Real(2) * most_square));", "",
             "the sine of a crank's turn loses its third order",
             in_header("LegForms.ofTipsHoldTheSineAndCosineOfEveryTurn", ["machine/leg_forms_test"], "machine_test")),
    Mutation("telescope_range_end", "src/region/telescopic_strut_range.cpp",
             "range.lower = distance.least(leg.center)", "range.lower = distance.largest(leg.center)",
             "ranges of struts of variable length begin where they end",
             Gtest("region_test", "JointRanges.encloseTheJointValuesOfEveryPoint")),
]

CRITERION = [
    Mutation("limit_left_out", "src/dexterity/workspace_bounds.cpp", "range.lower() >= limits.lower() ? -INF",
             "range.upper() >= limits.lower() ? -INF", "lower joint limits that bind are left out",
             Gtest("dexterity_test", "JointLimits.noPointBreaksALimitThatIsLeftOut")),
    Mutation("tolerance_of_a_direction", "src/machine/tolerated_strut.cpp", "tangent.mid() * across[j]",
             "0.5 * tangent.mid() * across[j]", "rails turn by half of their tolerance", MACHINES),
    Mutation("built_error_constant", "src/dexterity/built_error.cpp", "length * (balls + Interval(by.length))",
             "length * balls", "errors of the tool forget the tolerance of lengths",
             Gtest("region_test", "BuiltError.isTheClosedFormOfOneLength")),
]

SEARCHES = [
    Mutation("inside_at_the_budget", "src/region/containment.cpp",
             "if (branchAndBound(open_, *this, budget_) == Ending::EXHAUSTED)",
             "if (branchAndBound(open_, *this, budget_) != Ending::SETTLED)",
             "a region is INSIDE where the budget ends the proof", Gtest("region_test",
             "Containment.endsWithItsBudget")),
    Mutation("half_of_the_centers", "src/region/center_looks.cpp",
             "open_.put({ halves.second, look.bound, look.room, node.angles });", "",
             "half of each box of centers is never looked at",
             Gtest("region_test", "ProofLog.closedBoxesFillTheSearchBox")),
    Mutation("rates_undecided", "src/region/path_looks.cpp",
             "if (held == BoxVerdict::OUTSIDE || verdict == BoxVerdict::INSIDE)", "if (held == BoxVerdict::OUTSIDE)",
             "joints may be too fast where that is not decided", Gtest("region_test",
             "JointRates.verdictsAgreeWithTheFeed")),
    Mutation("rates_of_acceleration", "src/region/path_looks.cpp",
             "(kind == Limit::Kind::JOINT_SPEED ? tool_speed : sqr(tool_speed))", "tool_speed",
             "accelerations grow with the speed instead of its square",
             Gtest("region_test", "PathSteps.accelerationsGrowWithTheSquareOfTheSpeed")),
    Mutation("feed_flipped", "src/region/rate_search.cpp", "feedAt(kind, limit, rate.upper).lower;",
             "feedAt(kind, limit, rate.lower).lower;", "the feed is what the slowest that joints may be allows",
             Gtest("region_test", "JointRates.theLargestFeedIsBracketed")),
    Mutation("volume_by_one_cut", "src/paving/set_volume.cpp", "shareWithin(cuts[k].cut.data(), cuts[k].count);",
             "shareWithin(cuts[k].cut.data(), std::min<std::size_t>(cuts[k].count, 1));",
             "volumes count one condition only at each box", Gtest("paving_test",
             "SetVolume.dextrousSetOfTheOrthoglide")),
    Mutation("volume_at_the_budget", "src/paving/set_volume.cpp",
             "std::fill_n(shares, count, Interval(0.0, 1.0));", "std::fill_n(shares, count, Interval(0.0));",
             "volumes leave out what was not looked at",
             Gtest("paving_test", "SetVolume.limitsEndItWithAnHonestBracket")),
    Mutation("component_by_any_box", "src/paving/components.cpp",
             "walk_.state(a) == CellState::INSIDE && walk_.state(b)",
             "walk_.state(a) == CellState::INSIDE || walk_.state(b)",
             "components hang together over boxes that are not INSIDE", COMPONENTS),
    Mutation("corners_do_not_touch", "src/paving/tree_walk.cpp",
             "face(a, one[k], 1) < face(b, other[k], 0)", "face(a, one[k], 1) <= face(b, other[k], 0)",
             "boxes that share a corner are apart",
             Gtest("paving_test", "Components.boxesThatShareACornerHangTogether")),
    Mutation("placement_of_slow_paths", "src/region/path_body_proof.cpp",
             "if (is_proved && body_.limits_.any() && !body_.workpiece_->solid)", "if (false)",
             "placed paths may be too fast", Gtest("region_test", "Placement.KeepsJointSpeedsByTheDefinition")),
    Mutation("placement_scale", "src/region/placement.cpp",
             "(Interval(result.least) + Interval(result.search.size_upper_bound)).upper();",
             "result.search.size_upper_bound;", "the largest scale is bounded from above without the least one",
             Gtest("region_test", "Placement.LargestScaleHoldsByTheDefinition")),
]

MUTATIONS = NUMBERS + MACHINES_AND_LEGS + CRITERION + SEARCHES + CHECKER_MUTATIONS
