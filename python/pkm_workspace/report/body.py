# SPDX-License-Identifier: BSD-3-Clause
"""Points and outlines of a region, from shape, dimensions, center and angle of an answer."""

import numpy as np

BOXES = ("cube", "square", "box")
ROUND = ("cylinder", "disc")


def turned(region, points):
    angle = region.get("angle") or 0.0
    turn = np.array([[np.cos(angle), -np.sin(angle), 0], [np.sin(angle), np.cos(angle), 0], [0, 0, 1]])
    return points @ turn.T


def half_sides(region):
    return np.array([*region.dimensions, 0.0, 0.0][:3]) / 2


def half_cylinder(region):
    """Half the height, and the radius."""
    height, radius = region.dimensions if len(region.dimensions) == 2 else (0.0, region.dimensions[0])
    return height / 2, radius


def surface_of(region):
    """The center, and corners, or ends of the axes, or points of the rims."""
    points = np.zeros((0, 3))
    if region.shape in BOXES:
        points = np.unique(np.array(np.meshgrid(*[[-1, 1]] * 3)).reshape(3, -1).T * half_sides(region), axis=0)
    elif region.shape in ROUND:
        height, radius = half_cylinder(region)
        rim = radius * np.array([[1, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0]])
        points = np.unique(np.vstack([rim + [0, 0, end] for end in (-height, height)]), axis=0)
    elif region.shape == "sphere":
        points = region.dimensions[0] * np.vstack([np.eye(3), -np.eye(3)])
    return np.array(region.center) + np.vstack([np.zeros((1, 3)), turned(region, points)])


def outline_of(region, center, axes):
    """Where a plane along two axes through the center cuts the region, or nothing."""
    first, second = axes
    if region.shape == "sphere" or (region.shape in ROUND and axes == (0, 1)):
        radius = region.dimensions[0] if region.shape == "sphere" else half_cylinder(region)[1]
        circle = np.linspace(0, 2 * np.pi, 90)
        return center[first] + radius * np.cos(circle), center[second] + radius * np.sin(circle)
    if region.shape not in BOXES + ROUND or (region.get("angle") and axes != (0, 1)):
        return None
    height, radius = half_cylinder(region) if region.shape in ROUND else (None, None)
    half = half_sides(region) if region.shape in BOXES else np.array([radius, radius, height])
    corners = np.zeros((5, 3))
    corners[:, first] = half[first] * np.array([-1, 1, 1, -1, -1])
    corners[:, second] = half[second] * np.array([-1, -1, 1, 1, -1])
    corners = turned(region, corners)
    return center[first] + corners[:, first], center[second] + corners[:, second]
