# SPDX-License-Identifier: BSD-3-Clause
"""Families of machines: what a design becomes a machine by. Each is a value that can be sent to another process."""

import hashlib
import importlib
import importlib.util
import inspect
import pathlib

from pkm_workspace.core import Machine, mix
from pkm_workspace.errors import PkmError


class Catalogue:
    """Machines by the options of pkm urdf: those that are fixed, and the parameters of the design."""

    def __init__(self, **fixed):
        self.fixed = fixed

    def __call__(self, **design):
        return Machine.from_numbers(**self.fixed, **design)

    def describe(self, designs):
        return {"catalogue": self.fixed}


class Mixture:
    """Machines between two URDFs: the parameter share is 0 for the first and 1 for the second, any number between."""

    def __init__(self, first, second):
        self.urdfs = [pathlib.Path(file).read_text(encoding="utf-8") for file in (first, second)]
        self.ends = None

    def __call__(self, share):
        if self.ends is None:
            self.ends = [Machine(urdf) for urdf in self.urdfs]
        return mix(*self.ends, share)

    def __getstate__(self):
        return {"urdfs": self.urdfs, "ends": None}

    def describe(self, designs):
        return {"mixture": self.urdfs}


class Files:
    """Machines by their URDFs: the parameter urdf is a file; others are keywords of Machine."""

    def __call__(self, urdf, **names):
        return Machine(urdf, **names)

    def describe(self, designs):
        return {"files": digest("".join(Machine(design["urdf"]).urdf for design in designs))}


class Function:
    """A function of Python from the design's parameters to a Machine: in a module, or in a file as FILE.py:NAME."""

    def __init__(self, function):
        self.place, self.pickled, self.function = None, None, None
        self.source = source_of(function)
        if isinstance(function, str):
            self.place, self.function = function, loaded(function)
        elif getattr(function, "__module__", "__main__") != "__main__" and "<" not in function.__qualname__:
            self.place = f"{function.__module__}:{function.__qualname__}"
        else:
            self.pickled = pickled(function)

    def __call__(self, **design):
        if self.function is None:
            self.function = loaded(self.place) if self.place else unpickled(self.pickled)
        machine = self.function(**design)
        if not isinstance(machine, Machine):
            raise PkmError(f"the family returned {machine!r}, which is no pkm_workspace.Machine")
        return machine

    def __getstate__(self):
        return {**self.__dict__, "function": None}

    def describe(self, designs):
        return {"function": self.place, "source": digest(self.source)}


def digest(text):
    """What tells a text from all others."""
    return hashlib.sha256(text.encode("utf-8", "surrogateescape")).hexdigest()[:16]


def source_of(function):
    """A function that is changed is another family."""
    if isinstance(function, str):
        module = function.rpartition(":")[0]
        return pathlib.Path(module).read_text(encoding="utf-8") if pathlib.Path(module).is_file() else function
    try:
        return inspect.getsource(function)
    except (OSError, TypeError):  # typed in by hand, or an object that can be called
        code = getattr(function, "__code__", None)
        return repr(code and (code.co_code, code.co_names, [c for c in code.co_consts if isinstance(c, (int, float, str))]))


def loaded(place):
    module, _, name = place.rpartition(":")
    if not module or not name:
        raise PkmError(f"'{place}' is no place of a function: give FILE.py:NAME or MODULE:NAME")
    try:
        if module.endswith(".py"):
            spec = importlib.util.spec_from_file_location("pkm_workspace_family", module)
            found = importlib.util.module_from_spec(spec)
            spec.loader.exec_module(found)
        else:
            found = importlib.import_module(module)
        return getattr(found, name)
    except (ImportError, AttributeError, OSError) as reason:
        raise PkmError(f"the family {place} cannot be loaded: {reason}") from reason


def pickled(function):
    try:
        import cloudpickle
    except ImportError:
        raise PkmError("a function of the program itself can be sent to other processes with cloudpickle only (Debian: "
                       "python3-cloudpickle): install it, or put the function into a module") from None
    return cloudpickle.dumps(function)


def unpickled(text):
    import pickle
    return pickle.loads(text)


def family_of(family):
    if isinstance(family, (Catalogue, Mixture, Files, Function)):
        return family
    if callable(family) or isinstance(family, str):
        return Function(family)
    raise PkmError(f"{family!r} is no family: give a function that returns a Machine, or study.Catalogue(machine=...), "
                   "study.Mixture(FILE, FILE), study.Files()")
