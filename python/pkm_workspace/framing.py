# SPDX-License-Identifier: BSD-3-Clause
"""Where a camera stands that has a whole machine in its picture. Standard library only."""

import itertools
import math
import xml.etree.ElementTree as ElementTree

VIEW_ANGLE = math.radians(45.0)  # of rviz's camera, upwards and downwards together
FILLED = 0.62  # of the picture's height; the rest is for labels, which stand around the machine
RAISED = 0.04  # of the height: more of them stand below it
REACH = FILLED * math.tan(0.5 * VIEW_ANGLE)  # from the middle of the picture, at distance 1
USUAL_YAW = 0.92  # [rad]
CELLS = 10  # of a grid, along the machine's size, at least
MOST_STROKE = 0.5  # of the length of a branch
MOST_TURN = 1.0  # of a crank, either way [rad]


def numbers(text):
    return [float(number) for number in text.split()]


def product(one, other):
    return [[sum(one[i][k] * other[k][j] for k in range(4)) for j in range(4)] for i in range(4)]


def applied(move, point):
    return tuple(sum(move[i][k] * point[k] for k in range(3)) + move[i][3] for i in range(3))


def moved(x, y, z):
    return [[1.0, 0.0, 0.0, x], [0.0, 1.0, 0.0, y], [0.0, 0.0, 1.0, z], [0.0, 0.0, 0.0, 1.0]]


def origin_of(element):
    """The transform of an element's <origin>: a shift, and roll, pitch and yaw about fixed axes."""
    origin = element.find("origin")
    shift = numbers(origin.get("xyz", "0 0 0")) if origin is not None else [0.0, 0.0, 0.0]
    roll, pitch, yaw = numbers(origin.get("rpy", "0 0 0")) if origin is not None else [0.0, 0.0, 0.0]
    (cr, sr), (cp, sp), (cy, sy) = ((math.cos(angle), math.sin(angle)) for angle in (roll, pitch, yaw))
    turn = [[cy * cp, cy * sp * sr - sy * cr, cy * sp * cr + sy * sr, 0.0],
            [sy * cp, sy * sp * sr + cy * cr, sy * sp * cr - cy * sr, 0.0],
            [-sp, cp * sr, cp * cr, 0.0],
            [0.0, 0.0, 0.0, 1.0]]
    return product(moved(*shift), turn)


def half_sides(visual):
    """Of the box around what a link looks like; of a mesh nothing is known."""
    shape = visual.find("geometry")[0]
    if shape.tag == "box":
        return [0.5 * side for side in numbers(shape.get("size"))]
    if shape.tag in ("sphere", "cylinder"):
        radius = float(shape.get("radius"))
        return [radius, radius, 0.5 * float(shape.get("length", 2.0 * radius))]
    return [0.0, 0.0, 0.0]


def looks_of(link):
    """The corners of what a link looks like, in its frame."""
    for visual in link.findall("visual"):
        at = origin_of(visual)
        for signs in itertools.product((-1.0, 1.0), repeat=3):
            yield applied(at, [sign * side for sign, side in zip(signs, half_sides(visual))])


def root_of(urdf):
    """The name of the link that hangs at no joint."""
    robot = ElementTree.fromstring(urdf)
    children = {joint.find("child").get("link") for joint in robot.findall("joint")}
    return next(link.get("name") for link in robot.findall("link") if link.get("name") not in children)


def stroke_of(joint, most):
    """How far it goes below and above joint value 0 in the picture [m, rad]: as its limits let it, but no farther than
    that."""
    limit = joint.find("limit")
    for name, side in (("lower", -1.0), ("upper", 1.0)):
        wanted = side * float(limit.get(name, 0.0)) if limit is not None else 0.0
        yield side * min(max(wanted, 0.0), most)


def axis_of(joint):
    axis = joint.find("axis")
    if axis is None:
        return [1.0, 0.0, 0.0]
    vector = numbers(axis.get("xyz"))
    length = math.hypot(*vector)
    return [x / length for x in vector]


def turned_about(axis, angle, vector):
    """The vector turned about a unit vector (Rodrigues)."""
    along = dot(axis, vector)
    across = [axis[1] * vector[2] - axis[2] * vector[1], axis[2] * vector[0] - axis[0] * vector[2],
              axis[0] * vector[1] - axis[1] * vector[0]]
    return [math.cos(angle) * v + math.sin(angle) * c + (1.0 - math.cos(angle)) * along * a
            for v, c, a in zip(vector, across, axis)]


def slide(joint, start, end):
    """Where a branch's tip goes with its rail, or with a strut that gets longer: a function of the tip."""
    def places(tip):
        return [tuple(t + stroke * (e - s) for t, e, s in zip(tip, end, start))
                for stroke in stroke_of(joint, MOST_STROKE * math.dist(start, tip))]
    return places


def swing(joint, pivot, end, elbow):
    """The same with a crank that turns about the line from pivot to end."""
    axis, arm = ([b - a for a, b in zip(pivot, point)] for point in (end, elbow))

    def places(tip):
        ways = [[a - b for a, b in zip(turned_about(axis, angle, arm), arm)] for angle in stroke_of(joint, MOST_TURN)]
        return [tuple(p + w for p, w in zip(point, way)) for way in ways for point in (tip, elbow)]
    return places


class Walk:
    """Goes through a URDF at joint values 0, in its root's frame [m].

    points: around all that it shows and all that moves; rails: of each, two points that are 1 m apart.
    """

    def __init__(self, urdf):
        robot = ElementTree.fromstring(urdf)
        self.links = {link.get("name"): link for link in robot.findall("link")}
        self.joints = robot.findall("joint")
        self.points = []
        self.rails = []
        self.visit(root_of(urdf), moved(0.0, 0.0, 0.0), None)

    def visit(self, name, place, moves):
        """moves: where the joint that drives this link takes a tip; None: it stands still"""
        self.points += [applied(place, point) for point in looks_of(self.links[name])]
        hanging = self.hanging_at(name)
        if moves:
            self.points.append(applied(place, (0.0, 0.0, 0.0)))
            if not hanging:
                self.points += moves(self.points[-1])
        for joint in hanging:
            at = product(place, origin_of(joint))
            self.visit(joint.find("child").get("link"), at, moves or self.moves_of(joint, at))

    def hanging_at(self, name):
        return [joint for joint in self.joints if joint.find("parent").get("link") == name]

    def moves_of(self, joint, at):
        line = applied(at, (0.0, 0.0, 0.0)), applied(at, axis_of(joint))
        if joint.get("type") == "prismatic":
            self.rails.append(line)
            return slide(joint, *line)
        for elbow in self.hanging_at(joint.find("child").get("link")):
            mimic = elbow.find("mimic")
            if mimic is not None and mimic.get("joint") == joint.get("name") and joint.find("mimic") is None:
                return swing(joint, *line, applied(product(at, origin_of(elbow)), (0.0, 0.0, 0.0)))
        return None


def turned(quaternion, point):
    x, y, z, w = quaternion
    t = [2.0 * (y * point[2] - z * point[1]), 2.0 * (z * point[0] - x * point[2]), 2.0 * (x * point[1] - y * point[0])]
    return [point[0] + w * t[0] + y * t[2] - z * t[1],
            point[1] + w * t[1] + z * t[0] - x * t[2],
            point[2] + w * t[2] + x * t[1] - y * t[0]]


def dot(one, other):
    return sum(a * b for a, b in zip(one, other))


class Framing:
    """An orbit's distance and focal point that fill the picture with a machine, and cells of a grid below it [m].

    turn: quaternion of the root link in the fixed frame; pitch, yaw: of rviz's orbit [rad], None: one of its own.
    """

    def __init__(self, urdf, turn, pitch, yaw=None):
        walk = Walk(urdf)
        points = [turned(turn, point) for point in walk.points]
        if yaw is None:
            yaw = self.yaw_for([[turned(turn, point) for point in rail] for rail in walk.rails])
        self.yaw = yaw
        towards = [-math.cos(yaw) * math.cos(pitch), -math.sin(yaw) * math.cos(pitch), -math.sin(pitch)]
        right = [-math.sin(yaw), math.cos(yaw), 0.0]
        up = [-math.cos(yaw) * math.sin(pitch), -math.sin(yaw) * math.sin(pitch), math.cos(pitch)]
        least, largest = [min(values) for values in zip(*points)], [max(values) for values in zip(*points)]
        self.focus = [0.5 * (low + high) for low, high in zip(least, largest)]
        for _ in range(20):  # to the middle of what is seen, which perspective moves
            offsets = [[c - f for c, f in zip(point, self.focus)] for point in points]
            self.distance = max(max(abs(dot(o, right)), abs(dot(o, up))) / REACH - dot(o, towards) for o in offsets)
            for axis in (right, up):
                seen = [dot(o, axis) / (self.distance + dot(o, towards)) for o in offsets]
                shift = 0.5 * (min(seen) + max(seen)) * self.distance
                self.focus = [f + shift * a for f, a in zip(self.focus, axis)]
        self.focus = [f - RAISED / FILLED * 2.0 * REACH * self.distance * a for f, a in zip(self.focus, up)]
        self.cell = round_below(math.dist(least, largest) / CELLS)

    @staticmethod
    def yaw_for(rails):
        """Where columns stand around the tool: one behind it, the others left and right; else USUAL_YAW."""
        if not rails or any(abs(end[2] - start[2]) < 0.9 * math.dist(start, end) for start, end in rails):
            return USUAL_YAW
        middle = [sum(start[k] for start, _ in rails) / len(rails) for k in range(2)]
        opposite = [math.atan2(middle[1] - start[1], middle[0] - start[0]) for start, _ in rails]
        return min(opposite, key=lambda yaw: abs(math.remainder(yaw - USUAL_YAW, 2.0 * math.pi))) % (2.0 * math.pi)


def round_below(value):
    """The largest of 1, 2 and 5 times a power of ten that is not above it."""
    power = 10.0 ** math.floor(math.log10(value))
    return max(step * power for step in (1.0, 2.0, 5.0) if step * power <= value)
