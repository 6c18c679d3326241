#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""pkm with tolerances: all machines that could have been built, and how exactly one has to be."""
import json
import pathlib
import subprocess
import unittest

from pkm import ORTHOGLIDE, CommandTest, run

DRAW = pathlib.Path(__file__).resolve().parents[2] / "scripts" / "draw_shares"

SOME = ("--tolerance-slider", 1e-4, "--tolerance-length", 1e-4)


PLACE = ("--center", 0, 0, 0, "--sides", 0.1, 0.1, 0.1)


class Tolerances(CommandTest):
    def ask(self, command, *words):
        return self.answer(command, "--urdf", ORTHOGLIDE, *words)

    def refused(self, words, reason):
        process = run(*words)
        self.assertEqual((process.returncode, process.stdout), (2, ""))
        self.assertRegex(" ".join(process.stderr.split()), reason)

    def test_largest_is_robust_and_says_so(self):
        exact = self.ask("largest", "--accuracy", 1e-4)
        robust = self.ask("largest", "--accuracy", 1e-4, *SOME)
        self.assertLessEqual(robust["size"], 0.6436538)
        self.assertGreaterEqual(robust["size_upper_bound"], 0.6436518)
        self.assertLess(robust["size_upper_bound"], exact["size"])
        self.assertEqual(robust["tolerances"], {"tolerance_slider": [1e-4], "tolerance_length": [1e-4]})
        self.assertNotIn("tolerances", exact)
        self.assertNotEqual(robust["geometry_hash"], exact["geometry_hash"])
        text = " ".join(self.text("largest", "--urdf", ORTHOGLIDE, *SOME).split())
        plain = " ".join(self.text("largest", "--urdf", ORTHOGLIDE).split())
        for said, word in ((text, self.assertIn), (plain, self.assertNotIn)):
            word("own aspect on every machine within its tolerances; no cube", said)
            word("has all its points dextrous in the machine's own aspect on every machine within its", said)
        self.assertIn("This is about every machine whose numbers differ from the given ones by at most "
                      "tolerance_length +-0.0001 m, tolerance_slider +-0.0001 m", text)

    def test_none_is_the_machine_itself(self):
        zeros = ("--tolerance-slider", 0, "--tolerance-direction", 0, 0, 0)
        exact, same = self.ask("largest"), self.ask("largest", *zeros)
        for answer in (exact, same):
            answer.pop("seconds")
        self.assertEqual(exact, same)

    def test_they_come_from_a_file(self):
        name = self.file("built.yaml", "tolerance_slider: 1e-4\ntolerance_length: [1e-4, 1e-4, 1e-4]\n")
        given, read = self.ask("largest", *SOME), self.ask("largest", "--tolerances", name)
        for answer in (given, read):
            answer.pop("seconds")
        self.assertEqual(given, read)
        odd = self.file("odd.yaml", "tolerance_slider: wide\ntolerance_depth: 1\ntolerance_length: -1\n")
        for reason in ("odd.yaml:1.*'wide' is not a number", "odd.yaml:2.*tolerance_depth",
                       "odd.yaml:3.*from 0 to 1000"):
            self.refused(("largest", "--urdf", ORTHOGLIDE, "--tolerances", odd), reason)

    def test_every_command_takes_them(self):
        place = ("--center", 0.08, 0.08, 0.08, "--sides", 0.6, 0.6, 0.6)
        self.assertEqual(self.ask("check", *place, *SOME)["verdict"], "inside")
        outside = self.ask("check", *place, "--tolerance-slider", 0.02)
        self.assertEqual(outside["verdict"], "outside")
        self.assertEqual(len(outside["bad_machine"]), 3)
        text = self.text("check", "--urdf", ORTHOGLIDE, *place, "--tolerance-slider", 0.02)
        self.assertIn("rail_x: slider off by", text)
        exact = self.ask("pave", "--resolution", 0.2)
        robust = self.ask("pave", "--resolution", 0.2, "--tolerance-length", 0.01)
        self.assertLess(robust["volume_lower"], exact["volume_lower"])
        self.assertLess(robust["volume_upper"], exact["volume_upper"])
        path = ("--segment", "start 0 0 0", "--segment", "line 0.4082 0.4082 0.4082")
        self.assertEqual(self.ask("path", *path)["verdict"], "inside")
        self.assertEqual(self.ask("path", *path, *SOME)["verdict"], "outside")

        there = ("--point", 0.1, 0.2, 0.05)
        exact, robust = self.ask("evaluate", *there), self.ask("evaluate", *there, "--tolerance-direction", 0.01)
        self.assertEqual((True, True), (exact["satisfies"], robust["satisfies"]))
        for name in ("psi", "rho", "condition", "det_a", "serial_singularity", "parallel_singularity"):
            self.assertEqual(exact[name], robust[name])  # numbers of the machine that was meant
        for k in range(3):
            self.assertLess(robust["psi_bounds"][k][0], exact["psi_bounds"][k][0])
            self.assertGreater(robust["psi_bounds"][k][1], exact["psi_bounds"][k][1])

    def test_an_option_counts_in_place_of_the_file(self):
        name = self.file("built.yaml", "tolerance_slider: 1e-4\ntolerance_length: 3e-4\n")
        file, option = ("--tolerances", name), ("--tolerance-length", 1e-4)
        for words in ((*file, *option), (*option, *file)):
            self.assertEqual(self.ask("largest", *words)["tolerances"],
                             {"tolerance_slider": [1e-4], "tolerance_length": [1e-4]})
        self.refused(("largest", "--urdf", ORTHOGLIDE, "--tolerances", name, "--tolerances", name), "a second time")

    def test_the_urdf_has_them(self):
        given = ("--tolerance-length", 1e-4, "--tolerance-slider", 1e-4, 0, 0)
        built = self.machine("--machine", "orthoglide", *given)
        asked, read = self.ask("largest", *given), self.answer("largest", "--urdf", built)
        for answer in (asked, read):
            answer.pop("seconds")
        self.assertEqual(asked, read)
        off = self.answer("largest", "--urdf", built, "--tolerance-length", 0, "--tolerance-slider", 0)
        self.assertNotIn("tolerances", off)
        self.assertEqual(off["size"], self.ask("largest")["size"])
        tolerated = self.answer("tolerate", "--urdf", built, *PLACE)
        self.assertGreater(tolerated["holds"], 100)
        delta = self.machine("--linear-delta", "--rail-radius", 0.13, "--platform-radius", 0.03, "--length", 0.269,
                             "--travel", 0, 0.35, "--tolerance-direction", 1e-3)
        self.assertEqual(self.answer("evaluate", "--urdf", delta, "--point", 0, 0, 0)["tolerances"],
                         {"tolerance_direction": [1e-3]})
        self.refused(("urdf", "--machine", "orthoglide", "--tolerance-length", 0.5), "a tenth of the strut's length")
        self.refused(("urdf", "--template", "--tolerance-length", 1e-4), "give them with --from")

    def test_compares_machines_within_their_own(self):
        words = ("compare", "--accuracy", 0.01, "--urdf", ORTHOGLIDE, "--urdf", ORTHOGLIDE, "--tolerance-length", 5e-3)
        exact, robust = self.answer(*words)["machines"]
        self.assertNotIn("tolerances", exact)
        self.assertEqual(robust["tolerances"], {"tolerance_length": [5e-3]})
        self.assertLess(robust["size_upper_bound"], exact["size"])
        self.assertLessEqual(robust["size"], self.ask("largest", "--tolerance-length", 5e-3)["size_upper_bound"])
        self.assertIs(robust["singularities"]["region"]["parallel"]["exists"], False)
        self.refused(("compare", "--tolerance-length", 1e-4, "--urdf", ORTHOGLIDE), "give it after the --urdf")
        self.refused((*words, "--tolerance-length", 1e-4), "a second time for the same machine")

    def test_studies_machines_within_the_same(self):
        words = ("study", "--machine", "uranesx", "--parameter", "R-r", "--range", 0.4, 0.44, "--shape", "square",
                 "--accuracy", 2e-3)
        exact, robust = self.answer(*words), self.answer(*words, "--tolerance-length", 5e-3)
        self.assertEqual((exact["status"], robust["status"]), ("proven", "proven"))
        self.assertLess(robust["size_upper_bound"], exact["size"])
        self.assertEqual(robust["tolerances"], {"tolerance_length": [5e-3]})
        text = " ".join(self.text(*words, "--tolerance-length", 1e-3).split())
        self.assertIn("Here a machine has a region when every machine within its tolerances has it.", text)
        built = self.machine("--machine", "orthoglide", "--tolerance-length", 1e-4)
        ends = ("study", "--urdf", ORTHOGLIDE, "--urdf", built, "--range", 0, 1, "--accuracy", 0.05)
        self.refused(ends, "have different tolerances: give both the same")
        self.assertEqual(self.answer(*ends, "--tolerance-length", 1e-4)["tolerances"], {"tolerance_length": [1e-4]})

    def test_tolerate(self):
        words = ("--center", 0.0862, 0.0862, 0.0862, "--sides", 0.64, 0.64, 0.64)
        found = self.ask("tolerate", *words, *SOME)
        self.assertLess(found["holds"], found["fails"])
        self.assertLess(found["fails"], 1.25 * found["holds"])
        self.assertAlmostEqual(sum(share["share"] for share in found["shares"]), 1.0, delta=0.05)
        for factor, verdict in ((found["holds"], "inside"), (found["fails"], "outside")):
            scaled = ("--tolerance-slider", factor * 1e-4, "--tolerance-length", factor * 1e-4)
            self.assertEqual(self.ask("check", *words, *scaled)["verdict"], verdict)
        for leg in found["bad_machine"]:  # a vertex of the tolerances
            self.assertRegex(leg["text"], rf"^{leg['joint']}: slider off by ")
            for value in (*leg["slider"], leg["length"]):
                self.assertAlmostEqual(abs(value), found["fails"] * 1e-4, delta=1e-9)
            self.assertEqual((leg["platform"], leg["direction"], leg["zero"]), ([0, 0, 0], 0, 0))
        picture = self.folder / "shares.png"
        answer = self.file("answer.json", json.dumps(found))
        drawn = subprocess.run([DRAW, answer, picture], capture_output=True, text=True)
        self.assertEqual(drawn.returncode, 0, drawn.stderr)
        self.assertEqual(picture.read_bytes()[:4], b"\x89PNG")
        self.assertIn("no answer of pkm tolerate", subprocess.run([DRAW, self.file("none.json", "{}"), picture],
                                                                  capture_output=True, text=True).stderr)
        text = self.text("tolerate", "--urdf", ORTHOGLIDE, *words, *SOME)
        self.assertRegex(text, r"tolerance_slider +rail_. +[0-9.]+ % +#+")
        self.assertIn("(it is listed below)", " ".join(text.split()))

    def test_the_tool_is_within(self):
        box = ("--center", 0.05, 0.05, 0.05, "--sides", 0.4, 0.4, 0.4)
        found = self.ask("guarantee", *box, "--quantity", "position_error_max", "--tolerance-length", 1e-4)
        value = found["guarantees"][0]["value"]
        self.assertBrackets(value[0], 2.557e-4, value[1], 1e-7)
        self.assertLess(value[1] - value[0], 2e-3 * value[1])
        for bound, verdict in ((1.001 * value[1], "inside"), (0.99 * value[0], "outside")):
            asked = self.ask("check", *box, "--tolerance-length", 1e-4, "--position-error-max", bound)
            self.assertEqual(asked["verdict"], verdict)
        self.refused(("check", "--urdf", ORTHOGLIDE, *box, "--position-error-max", 1e-3), "needs the largest error")
        largest = ("largest", "--tolerance-length", 1e-4, "--position-error-max", 3e-4, "--accuracy", 0.01)
        self.assertEqual(self.ask(*largest)["status"], "proven")
        tolerable = self.ask("tolerate", *box, "--tolerance-length", 1e-4, "--position-error-max", 3e-4)
        self.assertBrackets(tolerable["holds"], 3e-4 / 2.557e-4, tolerable["fails"], 1e-3)
        self.assertIsNotNone(tolerable["bad_machine"])

    def test_bad_numbers_are_refused(self):
        for words, reason in (((-1e-4, ), r"tolerance_length = -0.0001 m must be from 0 to 1000 m"),
                              ((1e-4, 1e-4), "tolerance_length has 2 numbers, expected one for all legs, three"),
                              (("wide", ), "wide")):
            self.refused(("largest", "--urdf", ORTHOGLIDE, "--tolerance-length", *words), reason)
        for command in ("largest", "tolerate"):  # and nothing is said of a machine that was not read
            process = run(command, "--urdf", "none.urdf", "--psi", "auto", "--center", 0, 0, 0, "--radius", 0.1,
                          "--tolerance-length", -1)
            self.assertEqual(process.returncode, 2)
            self.assertNotRegex(process.stderr, "no point of the machine|one tolerance at least")
            self.assertIn("none.urdf: cannot be read", process.stderr)
        self.refused(("largest", "--urdf", ORTHOGLIDE, "--tolerance-direction", 0.2), "must be from 0 to 0.1 rad")
        self.refused(("largest", "--urdf", ORTHOGLIDE, "--tolerance-slider", 2),
                     "a tolerance of 2 m of its slider point must be at most 0.1 m, a tenth of the strut's length")
        self.refused(("largest", "--urdf", ORTHOGLIDE, "--tolerance-zero", 0, "--tolerance-zero", 0), "a second time")
        self.refused(("export", "--urdf", ORTHOGLIDE, *PLACE, "--format", "linuxcnc", *SOME), "believes the tool to be")
        place = ("--center", 0, 0, 0, "--radius", 0.1)
        self.refused(("tolerate", "--urdf", ORTHOGLIDE, *place), "give one tolerance at least")


if __name__ == "__main__":
    unittest.main()
