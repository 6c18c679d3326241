# SPDX-License-Identifier: BSD-3-Clause
"""What a mutation is: one text of one file, replaced by another that makes the program unsound, and its killer."""

import dataclasses
import re
from typing import ClassVar, Tuple, Union


@dataclasses.dataclass(frozen=True)
class Gtest:
    """A test of one of the programs of C++ tests."""
    program: str
    name: str  # Suite.test
    sources: Tuple[str, ...] = ()  # of the test: compiled with the mutation, where that is in a header that tests call
    RESULTS: ClassVar = (r"\[  PASSED  \] [1-9]", r"\[  FAILED  \]")

    def exists(self, root):
        suite, test = self.name.split(".")
        declared = re.compile(r"\bTEST(_F|_P)?\(\s*%s,\s*%s\s*\)" % (suite, test))
        paths = [root / source for source in self.sources] or (root / "test").glob("**/*_test.cpp")
        return any(declared.search(path.read_text(encoding="utf-8")) for path in paths)


@dataclasses.dataclass(frozen=True)
class PythonTest:
    """A test of the command."""
    file: str
    name: str  # Class.test
    RESULTS: ClassVar = (r"Ran [1-9]\d* tests? in", r"FAILED \(failures=")

    def exists(self, root):
        text = (root / self.file).read_text(encoding="utf-8")
        of_class, test = self.name.split(".")
        return re.search(r"^class %s\b" % of_class, text, re.M) and re.search(r"^    def %s\(" % test, text, re.M)


@dataclasses.dataclass(frozen=True)
class Mutation:
    name: str
    file: str
    old: str  # stands once in the file
    new: str
    breaks: str  # in words
    killer: Union[Gtest, PythonTest]
    rebuild: Tuple[str, ...] = ()  # sources of the library that a header reaches, as far as the killer needs them

    @property
    def sources(self):
        return (self.file,) if self.file.startswith("src/") and self.file.endswith(".cpp") else self.rebuild
