# SPDX-License-Identifier: BSD-3-Clause
"""Mutations of both checkers of certificates."""

from mutation import Gtest, Mutation, PythonTest

BOUND = "src/certificate/checked_bound.cpp"
REGION = "src/certificate/checked_region.cpp"
SETS = "src/certificate/checked_sets.cpp"
CLAIMS = "src/certificate/checked_claims.cpp"
SCRIPT = "scripts/check_certificate.py"
EXTENSIONS = "scripts/certificate_extensions.py"


def check(name):
    return PythonTest("test/cli/certificate_checks_test.py", "CertificateChecks." + name)


def numbers(name):
    return PythonTest("test/cli/certificate_numbers_test.py", "Numbers." + name)


PARTS = check("test_every_part_of_a_region")
ROOT = check("test_a_region_lies_in_the_box_of_its_proof")
LIMITS = check("test_joint_limits_of_every_leg_at_either_end")
LEAVES = check("test_every_leaf_of_a_bound")
CENTERS = check("test_a_bound_is_of_all_centers")
POINTS = check("test_points_of_a_bound")
BOXES = check("test_every_box_of_a_set")
PIECES = check("test_every_piece_of_a_path")
TREES = check("test_trees_have_no_less_and_no_more_leaves_than_their_cuts")
TRAVEL = check("test_points_that_are_bad_at_one_height")
JETS = Gtest("certificate_test", "Jet.holdsWhatItsMembersBecome", ("test/certificate/jet_test.cpp",))
PRODUCTS = numbers("test_sums_and_products")

OF_COMMAND = [
    Mutation("verify_leaf_of_bound", BOUND,
             'prove([&](const Cube& part) { return excludes(terms, size, part); }, box, MOST_SPLITS, "the reason");',
             "",
             "`pkm verify` believes the leaves of a bound", LEAVES),
    Mutation("verify_size_of_leaf", BOUND, "need(0.0 <= size && size <= size_,", "need(0.0 <= size,",
             "`pkm verify` takes reasons that are about larger regions", LEAVES),
    Mutation("verify_weights", BOUND, "need(term.weight >= 0.0,", "need(term.weight >= -1.0,",
             "`pkm verify` takes weights below 0", LEAVES),
    Mutation("verify_centers", BOUND, "need(hasAllCenters(centers_),", "need(true,",
             "`pkm verify` believes that no center lies beyond the box of the search", CENTERS),
    Mutation("verify_points_of_body", BOUND, "need(body_.has(points_.back().fixed, points_.back().per_size),",
             "need(true,", "`pkm verify` takes points that the body does not have", POINTS),
    Mutation("verify_bad_points", BOUND, "need(value.isNegative(),", "need(true,",
             "`pkm verify` believes that points are bad", POINTS),
    Mutation("verify_travel_of_bad_points", BOUND, "need(!travel_axis_ || push(bad_.back().why) == 0,", "need(true,",
             "`pkm verify` takes points that are bad at one height only for bad along the rails", TRAVEL),
    Mutation("verify_box_of_region",
             REGION, "need(Exact(root.lower[j]) <= lower_[j] && upper_[j] <= Exact(root.upper[j]),",
             "need(Exact(root.lower[j]) <= lower_[j],", "`pkm verify` does not compare a region with its box", ROOT),
    Mutation("verify_leaf_of_region", REGION,
             'prove([this](const Cube& part) { return holds(part); }, box, MOST_SPLITS, "the criterion");', "",
             "`pkm verify` believes the leaves of a region", PARTS),
    Mutation("verify_misses", REGION, "(squared - ballOf(radius_) * ballOf(radius_)).isPositive();",
             "(squared - Ball(0.5) * ballOf(radius_) * ballOf(radius_)).isPositive();",
             "`pkm verify` takes parts of a ball for beyond it", PARTS),
    Mutation("verify_aspect", REGION,
             'need(isInAspect(claims_, pointAt(center_)), "the center is in another aspect");', "",
             "`pkm verify` forgets the aspect of a region", PARTS),
    Mutation("verify_one_factor", SETS, "isGood) && isBounded(false) && isBounded(true);",
             "isGood) && isBounded(true);",
             "`pkm verify` forgets psi_min inside", PARTS),
    Mutation("verify_upper_limits", SETS, "for (const int side : { 0, 1 })\n      if (claims.hasLimit(leg, side))",
             "for (const int side : { 0 })\n      if (claims.hasLimit(leg, side))",
             "`pkm verify` forgets upper joint limits inside", LIMITS),
    Mutation("verify_definite", SETS, "- rest / second * rest).isPositive();", ").isPositive();",
             "`pkm verify` skips the last step of an elimination", PARTS),
    Mutation("verify_boxes_outside", SETS,
             'prove([&](const Cube& part) { return excludes(question, part); }, box, MOST_SPLITS, "the reason");', "",
             "`pkm verify` believes the reasons of boxes outside", BOXES),
    Mutation("verify_end_of_path", SETS, "cuts.front() == 0 && cuts.back() == 1,", "cuts.front() == 0,",
             "`pkm verify` takes a part of a segment for all of it", PIECES),
    Mutation("verify_pieces", SETS, 'prove(isGoodFor, times, MOST_SPLITS, "the criterion");', "",
             "`pkm verify` believes the pieces of a path", PIECES),
    Mutation("verify_jet_product", "src/certificate/jet.h", "const Ball all = f.range();", "const Ball all = f.value;",
             "slopes of products in `pkm verify` hold at the middle only", JETS),
    Mutation("verify_jet_root", "src/certificate/jet.h", "? Ball(1.0) / (sqrt(range) + root.value)",
             "? Ball(0.5) / root.value", "slopes of roots in `pkm verify` are tangents", JETS),
]

OF_SCRIPT = [
    Mutation("script_leaf_of_bound", SCRIPT,
             'proved(lambda a, b: self.excludes(a, b, leaf), low, high, SPLITS, "the reason")',
             "pass", "the script believes the leaves of a bound", LEAVES),
    Mutation("script_size_of_leaf", SCRIPT, 'need(0 <= leaf["size"] <= self.data["size"],', 'need(0 <= leaf["size"],',
             "the script takes reasons that are about larger regions", LEAVES),
    Mutation("script_weights", SCRIPT, 'need(term["weight"] >= 0,', "need(True,", "the script takes weights below 0",
             LEAVES),
    Mutation("script_centers", SCRIPT, "need(self.covers(j, sign, face),", "need(True,",
             "the script believes that no center lies beyond the box of the search", CENTERS),
    Mutation("script_points_of_body", SCRIPT, "and claims.body.has(point),", "and True,",
             "the script takes points that the body does not have", POINTS),
    Mutation("script_bad_points", SCRIPT, "need(self.claims.scalar(term, here).upper() < 0,", "need(True,",
             "the script believes that points are bad", POINTS),
    Mutation("script_box_of_region", SCRIPT,
             "all(a <= x and y <= b for a, x, y, b in zip(lower, self.low, self.high, upper)),",
             "all(a <= x for a, x in zip(lower, self.low)),", "the script does not compare a region with its box",
             ROOT),
    Mutation("script_leaf_of_region", SCRIPT, 'proved(self.inside, low, high, SPLITS, "the criterion")', "pass",
             "the script believes the leaves of a region", PARTS),
    Mutation("script_aspect", SCRIPT,
             'need(in_aspect(self.claims, [exact(x) for x in self.center]), "the center is in another aspect")', "pass",
             "the script forgets the aspect of a region", PARTS),
    Mutation("script_definite", SCRIPT, "return a > 0 and a * b > g * g and", "return a > 0 and a * b > g * g or",
             "the script proves definiteness by two minors", PARTS),
    Mutation("script_one_factor", SCRIPT, "for name in claims.factor for d in corners))",
             'for name in claims.factor if name != "psi_min" for d in corners))', "the script forgets psi_min inside",
             PARTS),
    Mutation("script_upper_limits", SCRIPT,
             'in zip(("joint_lower", "joint_upper"), claims.limits(i))\n                  if limit is not',
             'in zip(("joint_lower",), claims.limits(i))\n                  if limit is not',
             "the script forgets upper joint limits inside", LIMITS),
    Mutation("script_end_of_tree", SCRIPT, 'need(next(nodes, None) is None, "the tree goes on behind its end")', "pass",
             "the script takes trees that go on behind their end", TREES),
    Mutation("script_product_rounding", SCRIPT, "(r >> (P + 1)) + 6)", "r >> (P + 1))",
             "products in the script lose their roundings", PRODUCTS),
    Mutation("script_product_mixed", SCRIPT, "r += 2 * abs(a[j] * b[j - 1] + a[j - 1] * b[j])",
             "r += 2 * abs(a[j] * b[j - 1])", "products in the script lose half of their mixed second order", PRODUCTS),
    Mutation("script_root_chord", SCRIPT, "above_chord = ONE * ONE // (4 * a) + 1", "above_chord = below_chord + 1",
             "the square root in the script is taken for its chord", numbers("test_roots")),
    Mutation("script_inverse_chord", EXTENSIONS, "least = 2 * math.isqrt(a << P)", "least = most - 2",
             "the inverse in the script is taken for its chord", numbers("test_inverses")),
    Mutation("script_boxes_outside", EXTENSIONS, "core.proved(lambda a, b: self.outside(a, b, leaf), low, high,",
             "core.proved(lambda a, b: True, low, high,", "the script believes the reasons of boxes outside", BOXES),
    Mutation("script_aspect_of_boxes", EXTENSIONS,
             'need(core.in_aspect(self.claims, middle), "a box is in another aspect")', "pass",
             "the script forgets the aspect of boxes", BOXES),
    Mutation("script_end_of_path", EXTENSIONS, "cuts[0] == 0 and cuts[-1] == 1 and", "cuts[0] == 0 and",
             "the script takes a part of a segment for all of it", PIECES),
    Mutation("script_misses", EXTENSIONS, "sum(x ** 2 for x in gap) > self.measure(self.radius, h) ** 2",
             "sum(x ** 2 for x in gap) > self.measure(self.radius, h) ** 2 / 2",
             "the script takes parts of a ball for beyond it", PARTS),
    Mutation("script_travel_of_bad_points", EXTENSIONS,
             'need(not any(map(self.push, data["bad"])), "a bad point that others along the rails are not")', "pass",
             "the script takes points that are bad at one height only for bad along the rails", TRAVEL),
]

CHECKER_MUTATIONS = OF_COMMAND + OF_SCRIPT
