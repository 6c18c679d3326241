# SPDX-License-Identifier: BSD-3-Clause
"""What is larger than a bound holds a bad point, wherever it is: regions to try that on."""

import math
import re

from oracle import Region
from reasons import N, hold

MORE = 1 + 1e-6  # a region that is larger than a bound by this factor is above it


def placements(case, region, count=12):
    """Centers around one of a region: itself, close by, and anywhere near."""
    center, reach = region.center, max(region.dimensions)
    yield center
    for width in (1e-4, 1e-3, 1e-2, 0.1, 0.5):
        for _ in range(count // 4):
            yield [x + case.rng.gauss(0, width * reach) for x in center]


def beyond(bound, size):
    """Of a bound to a size that is good: samples do not tell it from one that is less than a hundredth larger."""
    return max(bound / size, 1.01)


def grown(region, factor, match, center):
    """A larger one of its family; where it stands on a plane, above that point of it."""
    given = [index for name, index in ((" of radius", [1]), (" of height", [0]), (" on a base", [0, 1]))
             if match["given"].startswith(name) for index in index]
    dimensions = [x if k in given else factor * x for k, x in enumerate(region.dimensions)]
    base = re.search(rf"standing on z = {N}", match["where"])
    if base:
        height = dimensions[0] if region.shape in ("disc", "cylinder") else dimensions[2]
        center = [*center[:2], float(base[1]) + height / 2]
    return Region(region.shape, dimensions, center, region.angle)


def no_region(case, region, factor, centers, match=None):
    for center in centers:
        large = grown(region, factor * MORE, match, center) if match else region.scaled(factor * MORE, center)
        if region.angle is not None:  # by its own angle, one that is near, or any
            large.angle += case.rng.choice((0, case.rng.gauss(0, 0.02), case.rng.uniform(0, 2 * math.pi)))
        hold(large.bad(case.machine, case.criterion, case.rng), large.dimensions, "at", large.center, "seems good")
