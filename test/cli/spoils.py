# SPDX-License-Identifier: BSD-3-Clause
"""What makes a true sentence a wrong one."""

import re


def times(prefix, factor):
    """Multiplies the number after what the expression matches."""
    pattern = re.compile(f"({prefix})(-?\\d+(?:\\.\\d+)?(?:e[-+]?\\d+)?)")
    return lambda text: pattern.sub(lambda found: found[1] + format(float(found[2]) * factor, ".9g"), text, count=1)


def instead(old, new):
    return lambda text: re.sub(old, new, text, count=1)


# claim: what makes it wrong
WRONG = {
    "largest": (times(r"dimensions +(?:0\.0+ x )?", 1.5), times(r"center +\(", 99),
                times(r"of\s+a\s+size\s+above\s+", 0.7), times(r"turned by +", 1.3)),
    "status": (instead("proven", "none"), ),
    "inside": (times(r"sides\s+\(", 9), times(r"radius ", 9)),
    "remark": (instead(r"all\s+rails\s+stay\s+within\s+their\s+limits|Joint limits are off: ([^.]|\.\d)*\.",
                       "'rail_1' would leave its upper limit, 0.2 m, by at least 99 m"), ),
    "bad point": (instead(r"(bad point +)\(.*\)", r"\1(GOOD)"), instead(r"is\s+not\s+(\w+) (.*?): [^;]*(;|\.\s+D)",
                                                                         r"is not \1 \2: it is ugly\3")),
    "good point": (instead(r"(: the point is \w+ in [^;]*)", r"\1 (not)"), times(r"factor is ", 2),
                   times(r"tool point \(", 99)),
    "no good point": (instead(r"tool point \(.*\) m", "tool point (GOOD)"),
                      instead(r"aspect: [^;.]*", "aspect: it is ugly")),
    "singular point": (instead(r"(bad point +)\(.*\)", r"\1(GOOD)"), times(r"no\s+further\s+than\s+", 1e12)),
    "centers": (instead(r"(all|none) are proved to", "some are proved to, and some not to,"), ),
    "path inside": (instead(r"transmission\s+factors\s+in\s+\[[\d.]+", "transmission factors in [0.999"), ),
    "path leaves": (times("t = ", 0.9), times("t = ", 1.1),
                    times("factor\\s+(?:reaches|is\\s+above|is\\s+below)\\s+", 2)),
    "path too fast": (times("t = ", 1.2), times("is\\s+(?=\\S+\\s+m/s,\\s+above)", 2),
                      times("feed\\s+is\\s+proved\\s+to\\s+be\\s+", 2), times("(?<= to )(?=\\S+\\s+m/s; at)", 0.5)),
    "placement": (times(r"up\s+to\s+(?=\S+\s+m\s+along)", 1.3), times(r"has\s+a\s+margin\s+above\s+", 0.4),
                  times(r"translation +\(", 9), times(r"at\s+all\s+scales\s+from\s+[01]\s+to\s+", 1.2),
                  times(r"allows\s+one\s+above\s+", 0.7),
                  instead(r"there\s+is\s+no\s+translation\s+that", "no translation that may be chosen has a margin "
                          "above 0.001 m. Whether one has any is not decided. [^;]*")),
    "volume": (times("have an? (?:volume|area) of ", 3), ),
    "components": (times(r"m\^[23] +\d+ +\(", 99), times("form ", 3)),
    "connected": (instead(r"(path +)\(.*\) m", r"\1(0.1, 0.2, 0.3) m"), times("path of ", 3)),
    "apart": (instead(r"to +\(.*\) m", "to  (GOOD)"), ),
    "singularities": (instead(r"none( +\|)", r"at (0.05, 0.02, 0.03) m\1"),
                      instead(r"there\s+are\s+[^.]*,\s+and\s+no", "there are no"),
                      times(r"\|eta\| \[m\] (?=0\.\d*[1-9])", 2)),
    "mean": (times("index\\s+is\\s+from\\s+", 1.5), ),
    "guarantee": (times(r"at\s+least\s+", 1.5), times(r"at\s+most\s+", 0.6), times(r"no\s+more\s+than\s+", 0.5),
                  times(r"no\s+less\s+than\s+", 2)),
    "study": (times(r"of\s+a\s+size\s+above\s+", 0.8), times(r"of\s+size\s+", 1.2)),
    "comparison": (times(r"cube: edge \[m\] +\w+ +", 1.3), times(r"volume for these strokes \[m\^3\] +\w+ +", 9)),
    "evaluation": (instead("yes", "no"), instead(r"no \(", "yes (")),
}
