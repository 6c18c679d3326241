# SPDX-License-Identifier: BSD-3-Clause
"""Ways to make a certificate false: its claims by more than its bracket is wide, or a step of its proof."""

import copy


def _larger_region(rng, data):
    data["region"]["size"] *= 1 + rng.uniform(0.02, 0.3)


def _moved_region(rng, data):
    axis = rng.randrange(2)
    data["region"]["center"][axis] += rng.choice((-1, 1)) * rng.uniform(0.5, 2) * data["region"]["size"]


def _lower_bound(rng, data):
    data["bound"]["size"] *= 1 - rng.uniform(0.01, 0.3)


def _other_length(rng, data):
    leg = rng.choice(data["machine"]["legs"])
    length = leg["length"]
    leg["length"] = (length[0] if isinstance(length, list) else length) * rng.choice((0.7, 0.8, 1.2, 1.3))


def _other_bounds(rng, data):
    name, value = rng.choice((("psi_min", 0.98), ("psi_max", 1.02)))  # but for single points
    data["criterion"][name] = value


def _other_aspect(_rng, data):
    data["criterion"]["aspect"] *= -1


def _other_body(rng, data):
    (kind, body), factor = *data["body"].items(), rng.choice((0.8, 1.25))
    for name in ("lower", "upper") if kind == "box" else ("radius",):
        body[name] = [[x * factor for x in pair] if kind == "box" else pair * factor for pair in body[name]]


def _cut_away(rng, data):
    tree = data[rng.choice(("region", "bound"))]["tree"]
    del tree[rng.randrange(len(tree))]


def _more_behind(rng, data):
    tree = data[rng.choice(("region", "bound"))]["tree"]
    tree.append(copy.deepcopy(tree[-1]))


def _leaf(rng, data):
    return rng.choice([node for node in data["bound"]["tree"] if isinstance(node, dict)])


def _no_reason(rng, data):
    _leaf(rng, data)["terms"] = []


def _negative_weight(rng, data):
    rng.choice(_leaf(rng, data)["terms"])["weight"] *= -1


def _reason_for_larger_ones(rng, data):
    _leaf(rng, data)["size"] = data["bound"]["size"] * (1 + rng.uniform(1e-9, 1))


def _fewer_centers(rng, data):
    axis = rng.choice([j for j in range(3) if j != data["bound"]["travel_axis"]])
    lower, upper = (corner[axis] for corner in data["bound"]["centers"])
    if rng.random() < 0.5:
        data["bound"]["centers"][0][axis] = lower + rng.uniform(0.05, 0.5) * (upper - lower)
    else:
        data["bound"]["centers"][1][axis] = upper - rng.uniform(0.05, 0.5) * (upper - lower)


def _point_outside(rng, data):
    point = rng.choice([p for p in data["bound"]["points"] if any(p["per_size"])])
    point["per_size"] = [x * rng.uniform(1.01, 3) for x in point["per_size"]]


def _good_point(rng, data):
    data["bound"]["bad"].append({"point": data["region"]["center"], "of": "psi_min",
                                 "v": [rng.uniform(-1, 1) for _ in range(3)]})


def _smaller_box(rng, data):
    axis = rng.randrange(2)
    data["region"]["box"][0][axis] += rng.uniform(1e-12, 0.5) * data["region"]["size"]


def _unknown_condition(rng, data):
    rng.choice((data["criterion"], data["machine"], data["machine"]["legs"][0], data))["stiffness_min"] = 1e6


def _no_number(rng, data):
    name = rng.choice(("size", "center", "box"))
    data["region"][name] = rng.choice(("1", None, [1], {}, float("nan"), float("inf")))


ALTERATIONS = (_larger_region, _moved_region, _lower_bound, _other_length, _other_bounds, _other_aspect, _other_body,
               _cut_away, _more_behind, _no_reason, _negative_weight, _reason_for_larger_ones, _fewer_centers,
               _point_outside, _good_point, _smaller_box, _unknown_condition, _no_number)


def altered(rng, data):
    """@return the certificate with one alteration, and the name of that"""
    alteration = rng.choice(ALTERATIONS)
    result = copy.deepcopy(data)
    alteration(rng, result)
    return result, alteration.__name__
