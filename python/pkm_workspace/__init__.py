# SPDX-License-Identifier: BSD-3-Clause
"""Proved answers about machines with three legs and a platform that never turns (docs/python.md).

    import pkm_workspace as pkm
    machine = pkm.Machine.from_numbers(machine="orthoglide")
    region = pkm.largest(machine, shape="cube", accuracy=1e-4)
    print(region.size, region.size_upper_bound, region.center)  # certified bracket [m]

Needs no ROS. Beside it, pkm_workspace.client is a client of the ROS node.
"""

from pkgutil import extend_path

__path__ = extend_path(__path__, __name__)  # messages and the core may be installed in another folder than this one
__all__ = ["Machine", "PkmError", "PkmFailure", "PkmWarning", "Result", "best_of_family", "check", "compare",
           "conditioning", "connect", "evaluate", "export", "guarantee", "largest", "path", "pave", "place",
           "singularities", "tolerate", "verify"]


def __getattr__(name):
    """The core is loaded when it is asked for first: messages and clients do without."""
    if name not in __all__ and name != "__version__":
        raise AttributeError(f"module '{__name__}' has no attribute '{name}'")
    from importlib import import_module
    core = import_module(__name__ + ".core")
    found = globals()[name] = getattr(core, name)
    return found


def __dir__():
    return sorted({*globals(), *__all__, "__version__"})
