# SPDX-License-Identifier: BSD-3-Clause
"""The core: machines, and one function for each command of pkm, with the same names of options and results."""

import inspect
import keyword
import logging
import os
import warnings

try:
    from pkm_workspace import _core
except ImportError as missing:
    raise ImportError("pkm_workspace was built without its core in Python, or it is not on the path: install "
                      "pybind11-dev, build again and source devel/setup.bash, or run pip install . in the source tree "
                      f"(docs/python.md); {missing}") from missing
from pkm_workspace.errors import PkmError, PkmFailure, PkmWarning

__version__ = _core.__version__
LOG = logging.getLogger("pkm_workspace")
SHORT = 96  # letters of a value in a repr


class Result(dict):
    """An answer: what the command pkm prints with --json, by the same names; members are attributes, too.

    Lengths are metres, times seconds, points in the frame of the URDF's root link.
    """

    __slots__ = ()

    def __getattr__(self, name):
        try:
            return self[name]
        except KeyError:
            raise AttributeError(f"the answer has no '{name}'; it has {', '.join(self)}") from None

    def __dir__(self):
        return [*super().__dir__(), *self]

    def __repr__(self):
        width = max(map(len, self), default=0)
        return "\n".join(["Result:"] + [f"  {name:{width}}  {brief(value)}" for name, value in self.items()])


def brief(value):
    """In one line."""
    if not isinstance(value, Result) and hasattr(value, "shape"):
        return f"array of the shape {value.shape}"
    if isinstance(value, Result):
        text = "{" + ", ".join(f"{name}: {brief(member)}" for name, member in value.items()) + "}"
    elif isinstance(value, list):
        text = "[" + ", ".join(map(brief, value[:9])) + (", ..." if len(value) > 9 else "") + "]"
    else:
        text = repr(value)
    return text if len(text) <= SHORT else text[:SHORT - 4] + " ..."


class Machine:
    """A machine: its URDF, as file or text, and how that is read.

    Keywords: rails, tcp_links, tool_link (names), tool (x, y, z [m] from where the legs meet), ball_axes, and
    tolerance_length [m] and the others of docs/tolerances.md. Can be pickled, and shared by threads.
    """

    __slots__ = ("_given", "_keywords", "answer")

    def __init__(self, urdf, **keywords):
        self._keep(_core.read(os.fspath(urdf), keywords), keywords, None)

    def _keep(self, given, keywords, answer):
        self._given, self._keywords, self.answer = given, keywords, answer
        warn(given.warnings)

    @classmethod
    def _made(cls, command, keywords):
        given, answer, _ = _core.make(command, keywords, Result)
        machine = cls.__new__(cls)
        machine._keep(given, {}, answer)
        return machine

    @classmethod
    def from_numbers(cls, **keywords):
        """A machine from the catalogue (machine="uranesx", length=1.0, rail_radius=0.5), by its measures (kind="rail",
        rail_radius, length, travel, ...) or from a machine file (from_="machine.yaml"): the options of pkm urdf.
        Lengths in metres, angles in degrees. answer: what the command says of it.
        """
        return cls._made("urdf", keywords)

    @classmethod
    def from_firmware(cls, file, **keywords):
        """A delta from the configuration of its controller: the options of pkm import. answer: what was taken of the
        file, and what was left aside and why.
        """
        return cls._made("import", {"file": file, **keywords})

    @property
    def name(self):
        return self._given.name

    @property
    def joints(self):
        """The names of the three joints that are driven."""
        return self._given.joints

    @property
    def urdf(self):
        """The text of its URDF."""
        return self._given.urdf

    def __reduce__(self):
        return _restored, (self.urdf, self._keywords)

    def __repr__(self):
        return f"<Machine '{self.name}', joints {', '.join(self.joints)}>"


def _restored(urdf, keywords):
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", PkmWarning)  # it was said when the machine was made
        return Machine(urdf, **keywords)


def mix(first, last, share, joint_limits=True):
    """The machine between two: each number of the geometry is (1 - share) that of the first and share that of the last.

    Both need the same kinds of legs and, with joint_limits, the same limits.
    """
    machine = Machine.__new__(Machine)
    machine._keep(_core.mix(first._given, last._given, share, joint_limits), {}, None)
    return machine


def warn(texts):
    for text in texts:
        warnings.warn(text, PkmWarning, stacklevel=4)


def ask(command, machines, keywords):
    """Runs a command of pkm. Raises PkmError for what is asked wrongly, PkmFailure where files fail."""
    try:
        given = [machine._given for machine in machines]
    except AttributeError:
        raise TypeError("machines come first, each a pkm_workspace.Machine; all else is given by name") from None
    answer, remarks, notes, lost, _ = _core.run(command, given, keywords, Result)
    if remarks:
        warn(remarks)
    for note in notes:
        LOG.info(note)
    if lost:
        raise PkmFailure(lost, answer)
    return answer


# How often a call gives a machine, and what Python gives without being told.
ONE, ANY, NONE = "machine", "machines", ""
COMMANDS = {
    "evaluate": ("evaluate", ONE, {}),
    "largest": ("largest", ONE, {}),
    "check": ("check", ONE, {}),
    "path": ("path", ONE, {}),
    "place": ("place", ONE, {}),
    "pave": ("pave", ONE, {"list_boxes": 10000000}),
    "connect": ("connect", ONE, {}),
    "compare": ("compare", ANY, {}),
    "best_of_family": ("study", ANY, {}),
    "singularities": ("singularities", ONE, {}),
    "guarantee": ("guarantee", ONE, {}),
    "tolerate": ("tolerate", ONE, {}),
    "conditioning": ("conditioning", ONE, {}),
    "export": ("export", ONE, {}),
    "verify": ("verify", NONE, {}),
}
OF_READING = {"urdf", "rails", "tcp-links", "tool-link", "tool", "ball-axes"}


def keyword_of(option):
    """psi_min of psi-min; from_ of from, which Python keeps for itself."""
    name = option.replace("-", "_")
    return name + "_" * keyword.iskeyword(name)


def keywords_of(name):
    """Of a function here: the keywords with what the command knows of them (name, values, repeatable, points)."""
    command, machines, _ = COMMANDS[name]
    return {keyword_of(option): (values, *more) for option, values, *more in _core.kinds_of(command)
            if not (machines and option in OF_READING)}


def signature_of(name):
    kind = inspect.Parameter
    given = {ONE: [kind(ONE, kind.POSITIONAL_ONLY)], ANY: [kind(ANY, kind.VAR_POSITIONAL)], NONE: []}
    first = [kind("file", kind.POSITIONAL_OR_KEYWORD)] if name == "verify" else given[COMMANDS[name][1]]
    names = [key for key in keywords_of(name) if not (name == "verify" and key == "file")]
    return inspect.Signature(first + [kind(key, kind.KEYWORD_ONLY, default=None) for key in names])


def function_of(name):
    command, machines, defaults = COMMANDS[name]
    if machines == ONE:
        def function(machine, /, **keywords):
            return ask(command, (machine,), {**defaults, **keywords} if defaults else keywords)
    elif machines == ANY:
        def function(*machines, **keywords):
            return ask(command, machines, keywords)
    else:
        def function(file, **keywords):
            return ask(command, (), {"file": file, **keywords})
    function.__name__ = function.__qualname__ = name
    function.__doc__ = _core.describe(command)
    function.__signature__ = signature_of(name)
    return function


globals().update({name: function_of(name) for name in COMMANDS})
