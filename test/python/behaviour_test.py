#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""What a program needs of the core in Python: refusals, threads, interrupts, certificates, texts, stubs."""

import concurrent.futures
import inspect
import pathlib
import signal
import subprocess
import sys
import unittest
import warnings

from support import DATA, URDF, CommandTest, core, machine, run, untimed

warnings.simplefilter("ignore", core.PkmWarning)
ROOT = pathlib.Path(__file__).resolve().parents[2]
FLAT = str(URDF / "uranesx.urdf")  # the proof of its cube has no end at such an accuracy
ENDLESS = {"shape": "cube", "accuracy": 1e-15, "time_limit": 0, "progress": True}
INTERRUPTED = """
import pkm_workspace as core, signal, sys
{before}
machine = core.Machine({urdf!r})
answer = core.largest(machine, **{keywords})
print(answer.status, 0 < answer.size < answer.size_upper_bound, flush=True)
{after}
"""


def refusal(function, *machines, **keywords):
    try:
        function(*machines, **keywords)
    except core.PkmError as error:
        return str(error)
    raise AssertionError("was not refused")


class Refusals(CommandTest):
    def setUp(self):
        super().setUp()
        self.machine = machine("orthoglide")

    def test_a_keyword_that_there_is_not_is_named_with_the_nearest(self):
        text = refusal(core.largest, self.machine, psi_mni=0.5, frobnicate=1)
        self.assertIn("psi_mni: there is no such option; did you mean psi_min?", text)
        self.assertIn("frobnicate: there is no such option\n", text)
        self.assertIn("help(pkm_workspace.largest)", text)

    def test_messages_are_those_of_the_command(self):
        for keywords, words in (({"psi_min": 3.0}, ["--psi-min", "3"]), ({"accuracy": -1}, ["--accuracy", "-1"]),
                                ({"shape": "tesseract"}, ["--shape", "tesseract"]),
                                ({"set": "reachable", "psi_max": 2}, ["--set", "reachable", "--psi-max", "2"])):
            said = run("largest", "--urdf", URDF / "orthoglide.urdf", *words).stderr.splitlines()
            said = [line[len("pkm: "):] for line in said if "pkm --help" not in line]
            plain = "\n".join(said).replace("--psi-min", "psi_min").replace("--psi-max", "psi_max").replace("--", "")
            self.assertEqual(refusal(core.largest, self.machine, **keywords), plain)

    def test_values_that_are_none(self):
        for value in (object(), {"a": 1}, 1j):
            self.assertIn("psi_min: a number, a text, or a list", refusal(core.largest, self.machine, psi_min=value))
        for number in (float("nan"), float("inf")):
            self.assertIn("not a finite number", refusal(core.largest, self.machine, psi_min=number))
        self.assertIn("needs 3 values", refusal(core.check, self.machine, center=(0, 0), sides=(1, 1, 1)))
        for rows in ([[0, 0]], [[0, 0, "x"]], [[0, 0, float("nan")]], []):
            self.assertIn("points", refusal(core.evaluate, self.machine, points=rows))
        self.assertIn("multi_precision", refusal(core.largest, self.machine, multi_precision=3))

    def test_None_and_False_count_as_not_given(self):
        self.assertEqual(untimed(core.largest(self.machine, accuracy=0.05, psi_min=None, turned=False)),
                         untimed(core.largest(self.machine, accuracy=0.05)))

    def test_machines_come_first(self):
        with self.assertRaisesRegex(TypeError, "machines come first"):
            core.largest("orthoglide")
        self.assertIn("give it once", refusal(core.largest, self.machine, urdf="x.urdf"))

    def test_machines_that_cannot_be(self):
        self.assertIn("nowhere.urdf", refusal(core.Machine, "nowhere.urdf"))
        self.assertIn("No link elements found", refusal(core.Machine, "<robot name='x'/>"))
        self.assertIn("did you mean rail_radius?", refusal(core.Machine.from_numbers, machine="uranesx", rail_radios=1))
        self.assertIn("no file is written", refusal(core.Machine.from_numbers, machine="uranesx",
                                                    output=self.folder / "x.urdf"))
        self.assertIn("which machine?", refusal(core.Machine.from_numbers))

    def test_warnings_are_warnings(self):
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always")
            core.largest(core.Machine(DATA / "equal_homes.urdf"), accuracy=0.1, shape="disc")
        self.assertTrue(any(issubclass(one.category, core.PkmWarning) for one in caught))
        self.assertFalse(any("--" in str(one.message) for one in caught))


class Certificates(CommandTest):
    def test_written_and_verified(self):
        file = self.folder / "cube.json"
        answer = core.largest(machine("orthoglide"), accuracy=0.05, certificate=file)
        self.assertEqual(answer.status, "proven")
        self.assertTrue(core.verify(file).verified)
        self.assertEqual(core.verify(file), self.answer("verify", file))
        file.write_text(file.read_text(encoding="utf-8").replace("1", "2"), encoding="utf-8")
        with self.assertRaises((core.PkmFailure, core.PkmError)):
            core.verify(file)

    def test_an_answer_is_not_lost_with_its_certificate(self):
        with self.assertRaisesRegex(core.PkmFailure, "nothing to certify") as caught:
            core.check(machine("orthoglide"), center=(0, 0, 0), sides=(2, 2, 2), certificate=self.folder / "no.json")
        self.assertEqual(caught.exception.answer.verdict, "outside")
        self.assertFalse((self.folder / "no.json").exists())


class Threads(CommandTest):
    def test_the_same_answers(self):
        shared = machine("orthoglide"), machine("tripod")
        tasks = [lambda: core.largest(shared[0], accuracy=0.01, threads=1),
                 lambda: core.check(shared[1], center=(0, 0, 0), sides=(0.1, 0.1, 0.1)),
                 lambda: core.evaluate(shared[0], points=[[0.01 * k, 0, 0] for k in range(50)]),
                 lambda: core.path(shared[0], segment=["start 0 0 0", "line 0.1 0 0"]),
                 lambda: core.pave(shared[0], resolution=0.3)]
        alone = [untimed(task()) for task in tasks]
        with concurrent.futures.ThreadPoolExecutor(8) as pool:
            together = list(pool.map(lambda k: untimed(tasks[k % len(tasks)]()), range(40)))
        for k, answer in enumerate(together):
            self.assertEqual(answer, alone[k % len(tasks)])

    def test_others_run_while_the_core_computes(self):
        """A thread of Python ends a search that has no other end."""
        before = "import os, threading\n" \
                 "threading.Timer(1, lambda: (print('runs', flush=True), os.kill(os.getpid(), signal.SIGINT))).start()"
        code = INTERRUPTED.format(before=before, urdf=FLAT, keywords=ENDLESS, after="")
        ended = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True)
        self.assertEqual(ended.stdout.splitlines(), ["runs", "stopped True"], ended.stderr)


class Interrupts(CommandTest):
    def interrupted(self, before="", after=""):
        """Lines of the program, which is interrupted once its search has told its progress; what else it says."""
        code = INTERRUPTED.format(before=before, urdf=FLAT, keywords=ENDLESS, after=after)
        program = subprocess.Popen([sys.executable, "-c", code], stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                                   text=True)
        self.assertIn(" s: ", program.stderr.readline())
        program.send_signal(signal.SIGINT)
        out, err = program.communicate()
        return out.splitlines(), err, program.returncode

    def test_the_best_so_far_with_its_bracket(self):
        lines, err, code = self.interrupted(after="print('goes on')")
        self.assertEqual((lines, code), (["stopped True", "goes on"], 0), err)

    def test_a_handler_of_the_program_is_called(self):
        lines, err, code = self.interrupted(
            before="signal.signal(signal.SIGINT, lambda *_: print('handled', flush=True))")
        self.assertEqual((lines, code), (["handled", "stopped True"], 0), err)

    def test_afterwards_Python_has_its_interrupt_back(self):
        lines, _, code = self.interrupted(after="signal.raise_signal(signal.SIGINT)\nprint('never')")
        self.assertEqual(lines, ["stopped True"])
        self.assertNotEqual(code, 0)

    def test_a_limit_of_time(self):
        answer = core.largest(machine("uranesx"), **{**ENDLESS, "time_limit": 0.2})
        self.assertEqual(answer.status, "stopped")
        for _ in range(3):
            late = core.evaluate(machine("orthoglide"), points=[[0, 0, 0]] * 100000, time_limit=0.05)
            self.assertGreater(late.points_left, 0)


class Texts(CommandTest):
    def test_reprs(self):
        self.assertEqual(repr(machine("delta")), "<Machine 'delta', joints crank_1, crank_2, crank_3>")
        text = repr(core.largest(machine("orthoglide"), accuracy=0.05))
        self.assertIn("status              'proven'", text)
        self.assertLessEqual(max(map(len, text.splitlines())), 120)
        self.assertIn("array of the shape", repr(core.pave(machine("orthoglide"), resolution=0.3)))

    def test_documentation_has_units_and_defaults(self):
        self.assertIn("accuracy NUMBER", core.largest.__doc__)
        self.assertIn("> 0 m", core.largest.__doc__)
        self.assertIn("[default 0.5]", core.largest.__doc__)
        self.assertNotIn("--psi", core.largest.__doc__)
        self.assertIn("psi_min", inspect.signature(core.largest).parameters)
        for name in core.__all__:
            self.assertTrue(getattr(core, name).__doc__, name)

    def test_the_stubs_are_those_of_the_module(self):
        subprocess.run([sys.executable, ROOT / "scripts/python_stubs", "--check"], check=True)

    def test_members_that_there_are_not(self):
        with self.assertRaisesRegex(AttributeError, "has no 'sizes'; it has accuracy"):
            core.largest(machine("orthoglide"), accuracy=0.1).sizes
        with self.assertRaises(AttributeError):
            core.lagest

    def test_needs_no_ROS(self):
        code = "import sys, pkm_workspace as p; p.largest; sys.exit(any(m.split('.')[0] in ('rospy', 'genpy') " \
               "for m in sys.modules))"
        subprocess.run([sys.executable, "-c", code], check=True)


if __name__ == "__main__":
    unittest.main()
