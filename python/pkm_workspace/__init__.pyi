# SPDX-License-Identifier: BSD-3-Clause
# Written by scripts/python_stubs.
from pkm_workspace.core import __version__ as __version__
from pkm_workspace.core import Machine as Machine
from pkm_workspace.core import PkmError as PkmError
from pkm_workspace.core import PkmFailure as PkmFailure
from pkm_workspace.core import PkmWarning as PkmWarning
from pkm_workspace.core import Result as Result
from pkm_workspace.core import best_of_family as best_of_family
from pkm_workspace.core import check as check
from pkm_workspace.core import compare as compare
from pkm_workspace.core import conditioning as conditioning
from pkm_workspace.core import connect as connect
from pkm_workspace.core import evaluate as evaluate
from pkm_workspace.core import export as export
from pkm_workspace.core import guarantee as guarantee
from pkm_workspace.core import largest as largest
from pkm_workspace.core import path as path
from pkm_workspace.core import pave as pave
from pkm_workspace.core import place as place
from pkm_workspace.core import singularities as singularities
from pkm_workspace.core import tolerate as tolerate
from pkm_workspace.core import verify as verify
