"""Where bytes without value come from, see `codegen.origins`."""

from __future__ import annotations

from crs_cc.ir.instruction import Variable
from crs_cc.ir.names import in_library
from crs_cc.runtime.codegen.origins import GREATEST, UNKNOWN, number_of
from crs_cc.runtime.diagnosis.inspect import Stopped
from crs_cc.runtime.sites import CallSite


def origin_of(stopped: Stopped, address: int) -> Variable | CallSite | None:
    """Return the variable, or the call that allocated the block, that a byte comes from."""
    word = address & ~3
    number = number_of(stopped.shadow[word : word + 4].tobytes())
    variables, calls = stopped.compiled.origins, stopped.compiled.call_sites
    if number == UNKNOWN:
        return None
    if GREATEST - number < len(variables):
        return variables[GREATEST - number]
    site = calls[number - 1] if number <= len(calls) else None
    return None if site is None or in_library(site.location) else site
