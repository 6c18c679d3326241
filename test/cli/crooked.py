# SPDX-License-Identifier: BSD-3-Clause
"""Machines that nobody would build: rails that lean, struts that differ, a tool off every strut. Numbers of six digits,
so that the three branches meet exactly."""

from decimal import Decimal

LEG = """
  <link name="carriage_{i}"/><link name="knuckle_{i}"/><link name="arm_{i}"/><link name="wrist_{i}"/>
  <link name="tip_{i}"/><link name="tcp_{i}"/>
  <joint name="rail_{i}" type="prismatic"><parent link="base"/><child link="carriage_{i}"/><origin xyz="{a}"/>
    <axis xyz="{e}"/><limit lower="{lower}" upper="{upper}" effort="1" velocity="1"/></joint>
  <joint name="u_{i}" type="continuous"><parent link="carriage_{i}"/><child link="knuckle_{i}"/>
    <axis xyz="{u}"/></joint>
  <joint name="v_{i}" type="continuous"><parent link="knuckle_{i}"/><child link="arm_{i}"/><axis xyz="{v}"/></joint>
  <joint name="parallelogram_back_{i}" type="continuous"><parent link="arm_{i}"/><child link="wrist_{i}"/>
    <origin xyz="{d}"/><axis xyz="{v}"/><mimic joint="v_{i}" multiplier="-1"/></joint>
  <joint name="u_back_{i}" type="continuous"><parent link="wrist_{i}"/><child link="tip_{i}"/><axis xyz="{u}"/>
    <mimic joint="u_{i}" multiplier="-1"/></joint>
  <joint name="tcp_joint_{i}" type="fixed"><parent link="tip_{i}"/><child link="tcp_{i}"/><origin xyz="{b}"/></joint>"""


def crooked(rng):
    """The text of a URDF: an Orthoglide whose every number is off, with struts of about 0.3 m."""
    legs = ""
    for i in range(3):
        near = lambda x, by: Decimal(round(1000000 * (x + rng.uniform(-by, by)))) / 1000000
        e = [near(k == i, 0.15) for k in range(3)]
        d = [near(0.3 * (k == i), 0.03) for k in range(3)]
        b = [near(0.02, 0.05) for _ in range(3)]
        a = [-x - y for x, y in zip(d, b)]
        u, v = ([int(k == (i + n) % 3) for k in range(3)] for n in (1, 2))
        text = {name: " ".join(map(str, vector)) for name, vector in dict(a=a, b=b, d=d, e=e, u=u, v=v).items()}
        legs += LEG.format(i=i + 1, lower=near(-0.15, 0.1), upper=near(0.25, 0.1), **text)
    return f'<robot name="crooked">\n  <link name="base"/>{legs}\n</robot>\n'
