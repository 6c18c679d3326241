# SPDX-License-Identifier: BSD-3-Clause
"""Every sentence of pkm with the word 'proved', and what holds it against the oracle."""

import re

import claims
import connection_claims
import guarantee_claims
import placement_claims
import rate_claims
import table_claims
from claims import BRACKET, QUALITY
from reasons import N, hold

GIVEN = rf"(?: of (?:radius|height) {N} m| on a base of {N} m x {N} m)?"
NO_REGION = (rf"no (?P<shape>\w+)(?P<given>{GIVEN}) "
             r"(?:of a size above (?P<size>[\d.e+-]+)|(?P<any>of any size)|"
             r"with a radius of (?P<from>\S+) to (?P<to>\S+) "
             r"times its height and a volume above (?P<volume>\S+) m\^3), "
             r"(?P<where>wherever its center|with this center|with its center in the search box|"
             rf"standing on z = {N} m(?: with the middle of its base in the search box)?)"
             r"(?P<turned> and however it is turned about the vertical)?, "
             rf"has all its points {QUALITY}\.(?: The rails are parallel: the same holds all along them\.)?")
CENTERS = (r"Of the centers from (?P<lower>\(.*?\)) m to (?P<upper>\(.*?\)) m, (?P<share>some|all|none) are proved to,?"
           r"(?: and some not to,)? carry a box with sides (?P<sides>\(.*?\)) m\.")
LEAVES = (r"Proved: the path (?P<leaves>leaves the set|is outside the set) on "
          r"(?:line '(?P<place>.*?)' \(line\)|(?P<segment>segment \d+)), "
          r"(?:near|between) t = (?P<t>[\d.e-]+)(?: and t = (?P<upper>[\d.e-]+))? of its way"
          r"(?:, and is outside somewhere between these)?: (?P<reason>.*?)\."
          r"(?: Before that it comes within rounding of the border (?P<open>.*?), where nothing is decided\."
          r"| Before that it is not decided (?P<undecided>.*?)\.)?" + rate_claims.RATES +
          r"(?: Joint limits are off: .*)?")
MEAN = (rf"Proved: the global conditioning index is from (?P<lower>{N}) to (?P<upper>{N})"
        r"(?P<complete>, to the accuracy asked for)?\.(?: .*?\.)?")
NO_MEAN = (r"Nothing is proved of the global conditioning index: "
           r"(?:.* ended the computation|the set has no proved volume)\.")
VOLUME = (rf"Proved: the points of the box that are {QUALITY} have an? (?P<measure>\w+) of (?P<bracket>{BRACKET}) "
          r"m\^[23]\.(?: The rails are parallel: the box is flat, across the axis they run along, and in every plane "
          r"parallel to it the area is the same\.)?(?P<early> Ended early by .*?: more time, boxes or memory give "
          r"closer bounds\.)?(?: Joint limits are off: .*\.)?")
STUDY = (r"Proved: (?:the machine with \S+ = (?P<parameter>\S+) m has the \w+ of size (?P<size>\S+) with its center at "
         r"(?P<center>\(.*?\)) m; no machine of the range has one|(?P<none>no machine of the range has a \w+)) "
         r"of a size above (?P<above>[\d.e+-]+?)"
         r"(?:; and none has a larger one(?: than this machine but with \S+ (?P<where>.*?))?)?\.")

# name: pattern, and the function that holds a match against the oracle; None where nothing is claimed
CLAIMS = {
    "largest": (rf"Proved: (?P<first>every point of the \w+{GIVEN} with this center and size"
                rf"(?:(?:, turned by this angle about the vertical)?(?:, standing on z = {N} m)?,)? is {QUALITY}; )?"
                + NO_REGION,
                claims.largest),
    "status": (r"status +((?:proven|none) \((?:proved to the accuracy asked for|no region (?:as large as the accuracy|"
               r"of any size) exists where the center may lie, proved(?:: the joint limits hold .* "
               r"fixed, lower = upper)?)\))", table_claims.status),
    "inside": (rf"Proved: every point of the \w+ is {QUALITY}\.", claims.inside),
    "remark": (rf"Proved: every point of the \w+ is {QUALITY}\. (?P<remark>Joint limits are off: .*)", claims.remark),
    "bad point": (rf"Proved: the bad point lies in the \w+ and is not {QUALITY}: (?P<reasons>.*)\.", claims.bad_point),
    "singular point": (r"Proved: no further than (?P<within>\S+) m from the bad point the \w+ has a point where two "
                       r"struts are one vector, so that det A is 0: a parallel singularity, which belongs to no "
                       r"aspect\.", claims.singular_point),
    "good point": (rf"Proved: the point is {QUALITY}; the nearest limit: (?P<limit>.*?)\."
                   r"(?: (?P<remark>Joint limits are off: .*))?", claims.good_point),
    "no good point": (rf"Proved: the point is not {QUALITY}: (?P<reasons>.*)\.", claims.no_good_point),
    "centers": (CENTERS, claims.shares),
    "path inside": (r"Proved: every point of the path is in the set\." + rate_claims.RATES +
                    r"(?: (?P<remark>Joint limits are off: .*))?", rate_claims.inside),
    "path too fast": (rate_claims.FAST, rate_claims.too_fast),
    "path leaves": (LEAVES, rate_claims.leaves),
    "placement": (placement_claims.PLACEMENT, placement_claims.placement),
    "volume": (VOLUME, claims.volume),
    "components": (connection_claims.COMPONENTS, connection_claims.components),
    "connected": (connection_claims.CONNECTED, connection_claims.connected),
    "apart": (connection_claims.APART, connection_claims.apart),
    "mean": (MEAN, table_claims.mean),
    "no mean": (NO_MEAN, None),
    "guarantee": (guarantee_claims.GUARANTEE, guarantee_claims.guarantee),
    "no guarantee": (guarantee_claims.NO_GUARANTEE, guarantee_claims.nothing),
    "singularities": (r"(?:Undecided: (?P<open>.*?), where .*?\. )?Proved: (?:no point that counts is singular|"
                      r"there are (?:(?P<there>.*), and )?no others)\.(?: (?P<remark>Joint limits are off: .*)|"
                      rf" {N}.*)?",
                      table_claims.singularities),
    "study": (STUDY, table_claims.study),
    "comparison": (r"Largest (?P<shape>\w+) of machine '(?P<name>.*)': proved to the accuracy asked for\.",
                   table_claims.comparison),
    "evaluation": (r"(?P<what>within reach|dextrous|reachable|own aspect) +(?P<answer>yes|no) \(proved\)",
                   table_claims.evaluated),
    "nothing": (r"Neither is proved: .*|Not decided .* Nothing that was looked at is proved to be outside\..*|"
                r"Joint limits are off: whether all rails stay within their limits is not proved\.", None),
}
STARTS = ("Proved", "Nothing", "Dextrous:", "Reachable:", "Joint limits", "Largest", "Of the", "Neither", "Undecided",
          "  ")


def sentences(text):
    """Paragraphs and rows of tables with the word 'proved', each in one line."""
    blocks = []
    for line in text.splitlines():
        goes_on = blocks and blocks[-1].startswith(" Undecided:") and line.startswith("Proved")
        if not blocks or not line or line.startswith(STARTS) and not goes_on:
            blocks.append("")
        blocks[-1] += " " + line
    return [" ".join(block.split()) for block in blocks if re.search("proved", block, re.I)]


def check(case):
    """Holds all sentences of the text of a case against the oracle. @return the names of the claims"""
    case.criterion = claims.criterion_of(case.definition or case.text)
    names = []
    for sentence in sentences(case.text):
        for name, (pattern, holds) in CLAIMS.items():
            match = re.fullmatch(pattern, sentence)
            if match:
                if holds:
                    holds(case, match)
                names.append(name)
                break
        else:
            hold(False, "no pattern knows the sentence:", sentence)
    return names
