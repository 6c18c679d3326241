#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Bad input: exit code 2, nothing on standard output, and a reason that names option, value and what is allowed."""

import subprocess
import unittest

from pkm import DATA, ORTHOGLIDE, PKM, URANESX, CommandTest, run

EVALUATE = f"evaluate --urdf {ORTHOGLIDE} "
LARGEST = f"largest --urdf {ORTHOGLIDE} "
CHECK = f"check --urdf {ORTHOGLIDE} "
PAVE = f"pave --urdf {ORTHOGLIDE} "
COMPARE = f"compare --urdf {ORTHOGLIDE} "
# rails that lean by a tenth of a degree: without their limits the tool might go up a hundred metres
UNBOUNDED = f"{{}} --urdf {DATA / 'lean_rails.urdf'} --joint-limits off"
URANESX_STUDY = "study --machine uranesx --parameter R-r "

# command line, and a regular expression for a line of standard error
REFUSALS = [
    ("", "a command is missing"),
    ("grow", "'grow' is not a command; allowed: evaluate, largest, check, path, place, pave, connect, compare, study, "
             "singularities, guarantee, tolerate, conditioning, urdf"),
    ("-h", "'-h' is not a command"),
    (f"connect --urdf {ORTHOGLIDE}", "--to X Y Z: the option is missing"),
    (f"connect --urdf {ORTHOGLIDE} --to 9 0 0 --box 0 1 0 1 0 1",
     r"the point \(9 0 0\) m is not in the box; give a box"),
    ("largest", "--urdf FILE: the option is missing"),
    ("largest --urdf", r"--urdf: needs one value \(FILE\), got 0"),
    ("largest --urdf /no/such/file.urdf", "--urdf /no/such/file.urdf: .*No such file or directory"),
    ("largest --urdf /", "--urdf /: /: cannot be read: it is a folder, not a regular file; name a file in it"),
    (f"largest --urdf {__file__}", "--urdf .*: the URDF is refused"),
    (LARGEST + "--psimin 0.5", "--psimin: there is no such option"),
    (LARGEST + "--psimean 0.5", "--psimean: there is no such option"),
    (LARGEST + "--psimin=0.5", "--psimin: there is no such option"),
    (LARGEST + "--threads 2 3", r"--threads 2 3: needs one value \(COUNT\), got 2"),
    (LARGEST + "--json yes", "--json yes: needs 0 values, got 1"),
    (LARGEST + "--json=yes", "--json yes: needs 0 values, got 1"),
    (LARGEST + "--psi-min 0.4 --psi-min 0.5", "--psi-min 0.5: the option is given a second time"),
    (LARGEST + "--psi-min 0", "--psi-min 0: 0 is out of range; allowed: > 0, without unit"),
    (LARGEST + "--psi-max -2", "--psi-max -2: -2 is out of range; allowed: > 0, without unit"),
    (LARGEST + "--psi-max 0.4", r"--psi-max 0.4: psi_max = 0.4\S* must be at least psi_min = 0.5 \(the default\) "),
    (LARGEST + "--psi-min 3", r"--psi-min 3: psi_max = 2 \(the default\) must be at least psi_min = 3 \(trans"),
    (LARGEST + "--psi-min 3 --psi-max 2.5", r"psi_max = 2.5 must be at least psi_min = 3 \(trans"),
    (LARGEST + "--psi-min 1e-200", "--psi-min 1e-200: psi_min = .* must be positive and finite"),
    (LARGEST + "--psi-min half", "--psi-min half: 'half' is not a number; allowed: > 0"),
    (LARGEST + "--psi-min 0.5x", "--psi-min 0.5x: '0.5x' is not a number"),
    (LARGEST + "--psi-min nan", "--psi-min nan: nan is not a finite number"),
    (LARGEST + "--psi-max inf", "--psi-max inf: inf is not a finite number"),
    (LARGEST + "--psi-max 1e999", "--psi-max 1e999: 1e999 is not a finite number that fits a double"),
    (LARGEST + "--accuracy 0", "--accuracy 0: 0 is out of range; allowed: > 0 m"),
    (LARGEST + "--accuracy 1e-400", "--accuracy 1e-400: 1e-400 is not a finite number that fits a double"),
    (LARGEST + "--accuracy 1e300", r"accuracy = 1e\+300 .*must be from 1e-18 to 1000 for this machine"),
    (LARGEST + "--accuracy 1e-300", "accuracy = 1e-300 .*must be from 1e-18 to 1000 for this machine"),
    (LARGEST + "--joint-limits yes", "--joint-limits yes: 'yes' is not known; allowed: on, off"),
    (LARGEST + "--shape egg", "--shape egg: 'egg' is not known; allowed: cube, square, box, sphere, disc, cylinder"),
    (LARGEST + "--shape cylinder", "--shape cylinder: shape = cylinder needs a ratio"),
    (LARGEST + "--shape cylinder --ratio 2 1", "--ratio 2 1: LO is larger than HI"),
    (LARGEST + "--shape cylinder --ratio 0 1", "--ratio 0 1: 0 is out of range; allowed: > 0"),
    (LARGEST + "--ratio 1 1", "--ratio 1 1: a ratio is for the shape cylinder only, the shape is cube"),
    (LARGEST + "--shape box", "--shape box: shape = box needs proportions"),
    (LARGEST + "--proportions 1 2 3", r"--proportions 1 2 3: proportions = \(1, 2, 3\) are for the shape box only"),
    (LARGEST + "--shape box --proportions 1 2", r"--proportions 1 2: needs 3 values \(A B C\), got 2"),
    (LARGEST + "--shape box --proportions 1 -2 1", "--proportions 1 -2 1: -2 is out of range; allowed: >= 0"),
    (LARGEST + "--shape box --proportions 0 0 0", r"--proportions 0 0 0: .*at least one of them positive"),
    (LARGEST + "--search-box 0 1 0 1 0", r"--search-box .*: needs 6 values \(X0 X1 Y0 Y1 Z0 Z1\), got 5"),
    (LARGEST + "--search-box 0 1 1 0 0 1", "--search-box .*: 1 m is above 0 m; allowed: Y0 <= Y1"),
    (LARGEST + "--search-box 0 1 0 1 0 1 --center 0 0 0", "--search-box .*, --center .*: only one of the two"),
    (LARGEST + "--base-z 0 --center 0 0 0", "--center 0 0 0, --base-z 0: .*give the search box X X Y Y Z Z"),
    (LARGEST + "--base-z 2 --search-box 0 1 0 1 0 1", "--search-box .*, --base-z 2: .*base_z = 2 m is not between"),
    (LARGEST + "--base-z 0 --shape sphere", "--base-z 0: .*a sphere has none: give a shape that has one"),
    (LARGEST + "--turned --shape sphere", "--turned: .*a sphere turned about the vertical is the same sphere"),
    (LARGEST + "--base-z nan", "--base-z nan: nan is not a finite number"),
    (LARGEST + "--base-z 1e10", "--base-z 1e10: 1e10 is out of range; allowed: a number .m. within 1000000000 m"),
    (LARGEST + "--radius 1", "--radius 1: a radius is for the shape cylinder only, the shape is cube"),
    (LARGEST + "--height 1 --shape disc", "--shape disc, --height 1: a height is for the shape cylinder only"),
    (LARGEST + "--footprint 1 1 --shape cube", "--shape cube, --footprint 1 1: a footprint is for the shape box only"),
    (LARGEST + "--footprint 1 0 --shape box", "--footprint 1 0: 0 is out of range; allowed: > 0 m"),
    (LARGEST + "--footprint 1 1 --shape box --proportions 1 1 1", "a box takes either proportions or a footprint"),
    (LARGEST + "--shape cylinder --radius 1 --height 1", "one of ratio, radius and height.* tells a check"),
    (LARGEST + "--shape cylinder --radius 0", "--radius 0: 0 is out of range; allowed: > 0 m"),
    (LARGEST + "--center 0 nan 0", "--center 0 nan 0: nan is not a finite number"),
    (LARGEST + "--time-limit -1", "--time-limit -1: -1 is out of range; allowed: >= 0 s"),
    (LARGEST + "--max-boxes 0", "--max-boxes 0: 0 is out of range; allowed: from 1 to 1000000000000"),
    (LARGEST + "--max-boxes 1e3", "--max-boxes 1e3: '1e3' is not a whole number"),
    (LARGEST + "--threads 0", "--threads 0: 0 is out of range; allowed: from 1 to 1024"),
    (LARGEST + "--threads 99999999999999999999", "--threads 9+: 9+ is out of range"),
    (LARGEST + "--rails a b", r"--rails a b: needs 3 values \(JOINT JOINT JOINT\), got 2"),
    (LARGEST + "--rails a b c", "'a'"),
    (LARGEST + "--tcp-links a b c", "'a'"),
    (LARGEST + "--threads 1 stray", "got 2"),
    (EVALUATE, "give either --point X Y Z, or --points FILE"),
    (EVALUATE + "--points /no/such/file", "--points /no/such/file: /no/such/file: cannot be read: No such file"),
    (EVALUATE + f"--points {__file__}", r"--points \S*: line [0-9]+: needs 3 numbers \(X Y Z\), got"),
    (EVALUATE + f"--point 0 0 0 --points {__file__}", "line [0-9]+: "),
    (LARGEST + "--set all", "--set all: 'all' is not known; allowed: dextrous, reachable"),
    (LARGEST + "--aspect any", "--aspect any: 'any' is not known; allowed: own, other, both"),
    (LARGEST + "--aspect both", "a region with bounded factors lies in one aspect"),
    (COMPARE + "--set reachable --aspect both", "machines are compared in one aspect: ask for their own or for the"),
    ("compare --paper --aspect own", "--paper: .*leave out --aspect"),
    (LARGEST + "--set reachable --psi-max 3", "--set reachable, --psi-max 3: a reachable set has no"),
    (LARGEST + "--kappa-max 0.9", "--kappa-max 0.9: 0.9 is out of range; allowed: >= 1, without unit"),
    (LARGEST + "--force-min 0", "--force-min 0: 0 is out of range; allowed: > 0, without unit"),
    (LARGEST + "--force-min 2 --force-max 1", "--force-max 1: force_max = 1 must be at least force_min = 2 "),
    (LARGEST + "--force-max 0.25", "force_max = 0.25 asks for psi of at least 4, and psi_max = 2: no point satisfies"),
    (LARGEST + "--force-min 4", "force_min = 4 asks for psi of at most 0.25, and psi_min = 0.5: no point satisfies"),
    (f"path --urdf {ORTHOGLIDE} --file /dev/null", "/dev/null"),
    (EVALUATE + "--point", r"--point: needs 3 values \(X Y Z\), got 0"),
    (EVALUATE + "--point 1 2", r"--point 1 2: needs 3 values \(X Y Z\), got 2"),
    (EVALUATE + "--point 1 2 -inf", r"--point 1 2 -inf: -inf is not a finite number .*; allowed: a number \[m\]"),
    (EVALUATE + "--point 0 2e9 0", r"--point 0 2e9 0: 2e9 is out of range; .*a number \[m\] within 1000000000 m"),
    (CHECK + "--center 1e300 0 0 --sides 1 1 1", r"--center 1e300 0 0: 1e300 is out of range; .* within 1000000000 m"),
    (PAVE + "--box 1e300 1.1e300 0 1 0 1", "--box .*: 1e300 is out of range; "),
    (EVALUATE + "--point 0 0 0 --accuracy 1", "--accuracy: there is no such option"),
    (EVALUATE + "-- 0 0 0", "'0': an option was expected here"),
    (CHECK + "--center 0 0 0",
     "give the region: --sides A B C, --radius R, --radius R --height H, or --shape and --size"),
    (CHECK + "--center 0 0 0 --radius 0", "--radius 0: must be one radius, from 1e-100 to 1e9 m"),
    (CHECK + "--center 0 0 0 --radius 0 --height 0",
     "--radius 0, --height 0: must be height and radius, each 0 or from"),
    (CHECK + "--center 0 0 0 --height 1", "--height needs --radius: they give a cylinder together"),
    (CHECK + "--center 0 0 0 --radius 1 --sides 1 1 1", "give a region by one of --size, --sides and --radius"),
    (CHECK + "--center 0 0 0 --size 1e200", r"--size 1e200: edge \[m\] must be from 1e-100 to 1e9"),
    (CHECK + "--center 0 0 0 --shape sphere --radius 1", "--shape needs --size: they give a region together"),
    (CHECK + "--centers 0 1 0 1 0 1 --radius 1",
     "only a box of --sides can have --centers; for another region give its --center"),
    (CHECK + "--center 0 0 0 --sides 1 1 -1", "--sides 1 1 -1: -1 is out of range; allowed: >= 0 m"),
    (CHECK + "--center 0 0 0 --sides 0 0 0",
     "--sides 0 0 0: must be three full sides, each 0 or from 1e-100 to 1e9 m, not all 0"),
    (PAVE + "--resolution 0", "--resolution 0: 0 is out of range; allowed: > 0 m"),
    (PAVE + "--list-boxes 0", "--list-boxes 0: 0 is out of range; allowed: from 1 to 10000000"),
    (PAVE + "--set all", "--set all: 'all' is not known; allowed: dextrous, reachable"),
    (PAVE + "--set reachable --psi-min 0.6", "--set reachable, --psi-min 0.6: a reachable set has no"),
    (PAVE + "--box 1 0 0 1 0 1", "--box .*: 1 m is above 0 m; allowed: X0 <= X1"),
    (PAVE + "--max-memory 0", "--max-memory 0: 0 is out of range; allowed: from 1 to "),
    (PAVE + "--max-memory 8191", "--max-memory 8191: too little for 2 runs of at least 4096 bytes each"),
    (PAVE + "--max-memory 1e6", "--max-memory 1e6: '1e6' is not a whole number"),
    (PAVE + "--save /no/such/folder/x", "--save /no/such/folder/x: .*cannot be written: No such"),
    (PAVE + "--save /dev/full", "--save /dev/full: .*cannot be written: it is not a regular file"),
    (PAVE + "--resume /no/such/file", "/no/such/file: cannot be read: No such"),
    (PAVE + f"--resume {__file__}", f"{__file__}: the paving is refused: it is not a paving"),
    ("compare", "give either --urdf FILE, once for each machine, or --paper"),
    (COMPARE + "--paper", "--urdf .*, --paper: give either"),
    (COMPARE + "--urdf /no/such/file.urdf", "--urdf /no/such/file.urdf: .*No such file or directory"),
    (f"compare --urdf /no/such/file.urdf --urdf {ORTHOGLIDE}", "--urdf /no/such/file.urdf: .*No such file"),
    (COMPARE + "--urdf", r"--urdf: needs one value \(FILE\), got 0"),
    (COMPARE + "--shape box", "--shape box: shape = box needs proportions"),
    (COMPARE + "--accuracy 0", "--accuracy 0: 0 is out of range; allowed: > 0 m"),
    ("compare --paper --kappa-max 3", "--paper: .*leave out --kappa-max"),
    ("compare --paper --psi-max 3", "--paper: .*leave out --psi-max"),
    (COMPARE + "--rails a b c", "'a'"),
    (COMPARE + "--tcp-links a b c", "'a'"),
    (f"compare --rails a b c --urdf {ORTHOGLIDE}", "--rails a b c: give it after the --urdf FILE"),
    (COMPARE + "--rails a b c --rails a b c", f"--rails a b c: given a second time for --urdf {ORTHOGLIDE}"),
    ("study", "--range LO HI: the option is missing"),
    ("study --range 0 1", "give either --machine and --parameter, or two machines"),
    ("study --machine uranesx --range 0 1", "--machine uranesx: give either --machine and --parameter"),
    (f"path --urdf {ORTHOGLIDE} --tool-speed 1e300", "--tool-speed 1e300: .*allowed: from 1e-09 to 1000000000 m/s"),
    (f"study --range 0 1 --urdf {ORTHOGLIDE}", "--urdf .*: give either"),
    (URANESX_STUDY + f"--range 0 1 --urdf {ORTHOGLIDE}", "--machine uranesx, --parameter R-r, --urdf .*: give either"),
    (URANESX_STUDY + "--range 0.5 0.3", "--range 0.5 0.3: LO is larger than HI"),
    (URANESX_STUDY + "--range 0.3 1.5", "--range 0.3 1.5, .*: R - r = .* must lie between 0 and the strut length"),
    (URANESX_STUDY + "--range 0.3 0.5 --shape cylinder --ratio 0.5 1", "--ratio 0.5 1: .*one shape"),
    (URANESX_STUDY + "--range 0.3 0.5 --shape box --proportions 0 0 1",
     "along the rails can be as long as one likes: ask for another shape$"),
    (f"largest --urdf {URANESX} --joint-limits off --shape box --proportions 0 0 1",
     "along the rails can be as long as one likes: ask for --joint-limits on, or for another shape$"),
    (UNBOUNDED.format("largest"), "longer than 1000 struts: ask for --joint-limits on, or for a --search-box within"),
    (UNBOUNDED.format("pave"), "longer than 1000 struts: ask for --joint-limits on, or for a --box$"),
    (UNBOUNDED.format("compare"), "longer than 1000 struts: ask for --joint-limits on$"),
    (UNBOUNDED.format("singularities"), "1000 struts: ask for --joint-limits on, or for a region by --center and"),
    (UNBOUNDED.format("conditioning"), "1000 struts: ask for --joint-limits on, or for a region by --center and"),
    (f"study --range 0 1 --urdf {ORTHOGLIDE} --urdf {URANESX}", "opposite working modes"),
    ("urdf", r"which machine\? Give its numbers \(--linear-delta .*--template writes one.*--machine orthoglide\|"),
    (LARGEST + "--psi best", "--psi best: 'best' is not known; allowed: auto"),
    (LARGEST + "--psi auto --psi-min 0.3", "--psi auto chooses the bounds of a dextrous set: leave out --psi-min"),
    (LARGEST + "--psi auto --set reachable", "--psi auto chooses the bounds of a dextrous set"),
    (LARGEST + "--tool-link drill --tool 0 0 1", "--tool-link drill, --tool 0 0 1: .*both tell the tool point; give"),
    (LARGEST + "--tool 0 1", r"--tool 0 1: needs 3 values \(X Y Z\), got 2"),
    (LARGEST + "--tool 0 0 inf", "--tool 0 0 inf: inf is not a finite number"),
    ("compare --tool 0 0 1 --urdf x", "--tool 0 0 1: give it after the --urdf FILE that it is about"),
    (LARGEST + "--tool-link drill", "tool_link names 'drill', which is not a link"),
    (COMPARE + "--psi auto", "--psi: there is no such option"),
    ("urdf --orthoglide --uranesx", "only one of --linear-delta, --from, --template, --orthoglide, --uranesx and"),
    ("urdf --uranesx --travel 0 1", "--uranesx, --travel 0 1: this machine has no such dimension: --travel"),
    ("urdf --uranesx --length 1 1 2", "the legs of this machine are alike; give --kind for legs that differ"),
    ("urdf --linear-delta", "rail_radius is missing: the distance of its rail"),
    ("urdf --linear-delta --length 1 2", r"--length 1 2: needs one value \(L\), or that for each of three legs, got 2"),
    ("urdf --length 0.3 --travel 0 1 --x 1 2 3", "x and y belong together, and y is missing"),
    ("urdf --length 0.3 --travel 1 0 --rail-radius 0.1", "leg 1: travel from 1 to 0 m, expected the lower end first"),
    ("urdf --length 0.1 --travel 0 1 --rail-radius 0.2", "the struts do not meet: check length, rail_radius and"),
    ("urdf --from /no/such/file.yaml", "--from /no/such/file.yaml: .*No such file or directory"),
    ("urdf --from /no/such/file.yaml --length 1", "numbers and a machine file cannot be given together"),
    ("urdf --linear-delta --tool 0 0", r"--tool 0 0: needs 3 values \(X Y Z\), got 2"),
    ("urdf --machine hexapod", "--machine hexapod: 'hexapod' is not known; allowed: orthoglide, "),
    ("urdf --machine orthoglide --length -1", "--length -1: -1 is out of range; allowed: > 0 m"),
    ("urdf --machine orthoglide --lambda 0.1", "--machine orthoglide, --lambda 0.1: this machine has no such dim"),
    ("urdf --machine uranesx --lambda 0.1 --rail-radius 1", "--rail-radius 1, --lambda 0.1: only one of the two"),
    ("urdf --machine uranesx --lambda 3", "--lambda 3: R - r = .* m must lie between 0 and the strut length L = 1 m"),
    ("urdf --machine orthoglide --output /no/such/folder/x", "--output /no/such/folder/x: cannot be written: No such"),
    ("urdf --machine orthoglide --output /dev/full", "--output /dev/full: cannot be written: it is not a reg"),
    ("urdf --machine orthoglide --length 1e308", r"--length 1e308: .*L = 1e\+308 m must be from 1e-9 m to 1e9 m"),
    ("urdf --machine uranesx --length 1e-300", "--length 1e-300: .*L = 1e-300 m must be from 1e-9 m to 1e9 m"),
    ("largest --x=", "--x: there is no such option"),
    (LARGEST + "--psi-min=", "--psi-min : '' is not a number; allowed: > 0"),
    (LARGEST + "--psi-min 0,5", "--psi-min 0,5: '0,5' has a comma; write a decimal point"),
]


class Refusals(CommandTest):
    def refusal(self, *words):
        process = run(*words)
        self.assertEqual(process.returncode, 2, process.stderr)
        self.assertEqual(process.stdout, "")
        return process.stderr

    def test_reason_names_option_value_and_what_is_allowed(self):
        for line, reason in REFUSALS:
            for words in (line.split(), [*line.split(), "--json"] if line else []):
                with self.subTest(words):
                    self.assertRegex(self.refusal(*words), f"(?m)^pkm: .*{reason}" if line else reason)

    def test_all_problems_are_told_at_once(self):
        reasons = self.refusal("largest", "--urdf", "/no/such/file", "--psi-min", "x", "--accuracy", -1, "--shape",
                               "egg", "--what", 3, "--center", 1, 2)
        for option in ("--urdf /no/such/file", "--psi-min x", "--accuracy -1", "--shape egg", "--what", "--center 1 2"):
            self.assertIn(f"pkm: {option}: ", reasons)

    def test_broken_urdf_is_named_with_its_place(self):
        broken = self.file("broken.urdf", self.with_limits(ORTHOGLIDE, 0.2, -0.1))
        reasons = self.refusal("evaluate", "--urdf", broken, "--point", 0, 0, 0)
        self.assertRegex(reasons, r"--urdf \S*broken.urdf: (.*\n)*.*rail_x.*0\.2")

    def test_lost_output_is_a_failure(self):
        with open("/dev/full", "w") as full:
            process = subprocess.run([PKM, "--help"], stdout=full, stderr=subprocess.PIPE, text=True)
        self.assertEqual(process.returncode, 1)
        self.assertRegex(process.stderr, "standard output cannot be written")


if __name__ == "__main__":
    unittest.main()
