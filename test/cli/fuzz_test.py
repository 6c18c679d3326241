#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Whatever stands on the command line: pkm answers or says what is wrong with it, and is never at a loss."""

import random
import re
import unittest

from pkm import MACHINES, CommandTest, run

SEED = 20261126
CASES = 25  # for each command
NUMBERS = ("0", "-0", "1", "-1", "0.5", "2", "0.1", "1e9", "1e-9", "1e308", "-1e308", "1e-308", "4.94e-324", "1e200",
           "1e-200", "1e100", "1e-100", "1e-300", "1e16", "inf", "-nan", "0x1p-3", "1e", "abc", "1,5", "", " ", "=",
           "\n")
COMMON = ("0.1", "0.2", "0.5", "1", "2")
SMALL = ("0", "1e-9", "1e-6", "1e-4", "0.001")  # as tolerances are
TEXTS = ("", " ", "x", "=", "\u00e9", "\n", "start 0 0 0", "line 1e308 0 0", "circle 0 0 0 0 0 1e-320", "line 0,1 0 0",
         "/", "/dev/null", "/no/such/file")
STRAY = ("--", "--=", "--x=", "--=1", "---", "-", "--no-such-option", "--json=", "--urdf=", "=")
REQUIRED = ("sides", "center", "point", "machine")
# so that no case lasts
BUDGET = {"time-limit": "0.05", "max-boxes": "100", "threads": "1", "max-looks": "1000", "max-memory": "100000"}


class Fuzz(CommandTest):
    def options(self, command):
        """Name and number of values of each option."""
        pattern = r"(?m)^  --([a-z-]+)(?: ([A-Za-z0-9_|]+(?: [A-Z0-9]+)*)(?:\.\.)?(?=  |$))?"
        listed = re.findall(pattern, self.text(command, "--help"))
        return {name: values.split() for name, values in listed if name != "help"}

    def value(self, chance, kind):
        common = chance.random() < 0.9
        if kind == "FILE":
            return chance.choice([*MACHINES.values()] if common else TEXTS)
        if "|" in kind:
            return chance.choice(kind.split("|") if common else TEXTS)
        if kind in ("LINE", "JOINT", "LINK"):
            return chance.choice(TEXTS)
        return chance.choice(COMMON if common else NUMBERS)

    def words(self, chance, options):
        share = min(0.15, 3 / len(options))  # few of many, so that not each case is refused
        chosen = {name: values for name, values in options.items()
                  if name not in BUDGET and (chance.random() < share or name in REQUIRED)}
        words = [word for name in BUDGET if name in options for word in (f"--{name}", BUDGET[name])]
        if "urdf" in options and "machine" not in chosen:
            words += ["--urdf", chance.choice(list(MACHINES.values()))]
            chosen.pop("urdf", None)
        for name, values in chosen.items():
            given = [self.value(chance, kind) for kind in values]
            if name.startswith("tolerance-") and chance.random() < 0.9:
                given = [chance.choice(SMALL)]
            if name == "tolerances" and chance.random() < 0.9:
                given = [self.file("tolerances.yaml", "tolerance_zero: 1e-5\ntolerance_length: [1e-4, 0, 1e-3]\n")]
            if given and chance.random() < 0.2:
                words += [f"--{name}={given[0]}", *given[1:]]
            else:
                words += [f"--{name}", *given]
        if chance.random() < 0.1:
            words.insert(chance.randrange(len(words) + 1), chance.choice(STRAY))
        return words

    def assertAtNoLoss(self, *words):
        process = run(*words)
        with self.subTest(words):
            self.assertIn(process.returncode, (0, 2), process.stderr)
            self.assertNotIn("defect", process.stderr)
            if process.returncode == 2:
                self.assertEqual(process.stdout, "")
                self.assertRegex(process.stderr, "^pkm: .")
        return process.returncode == 0

    def test_any_options(self):
        chance = random.Random(SEED)
        answered = 0
        for command in re.findall(r"(?m)^  ([a-z]+)  ", self.text("--help")):
            options = self.options(command)
            self.assertGreaterEqual(len(options), 3, command)
            for writes in ("output", "save", "mesh", "outer-mesh", "octomap"):
                options.pop(writes, None)
            for _ in range(CASES):
                answered += self.assertAtNoLoss(command, *self.words(chance, options))
        print(f"{answered} answered")
        self.assertGreater(answered, CASES)

    def test_any_dimensions(self):
        for number in NUMBERS:
            for machine in ("orthoglide", "uranesx"):
                self.assertAtNoLoss("urdf", "--machine", machine, "--length", number)
            for option in ("rail-radius", "platform-radius", "lambda"):
                self.assertAtNoLoss("urdf", "--machine", "uranesx", f"--{option}", number)

    def test_stray_words(self):
        for stray in STRAY:
            self.assertAtNoLoss(stray)
            self.assertAtNoLoss("largest", stray)

    def test_any_point(self):
        for machine in MACHINES.values():
            for number in NUMBERS:
                self.assertAtNoLoss("evaluate", "--urdf", machine, "--point", number, "0.1", number)


if __name__ == "__main__":
    print(f"seed {SEED}")
    unittest.main()
