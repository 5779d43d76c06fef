"""How a program stops because of an error: its slot has the location and the reason.

The stores are inline. A call would make every function keep the registers that its frame needs
across that call, and save and restore them at each entry and exit.
"""

from __future__ import annotations

from crs_cc.requests import FAILED, slot_offset
from crs_cc.runtime.codegen.indices import MAILBOX, SLOT_GLOBAL
from crs_cc.runtime.wasm import Instr


def note(site: Instr, value: Instr) -> list[Instr]:
    """Store a failure in the slot, and push `FAILED`.

    Args:
        site: pushes the number of its site.
        value: pushes the address or number to report.
    """
    return [
        ("global.get", SLOT_GLOBAL), site, ("i32.store", MAILBOX, slot_offset("error_site")),
        ("global.get", SLOT_GLOBAL), value, ("i32.store", MAILBOX, slot_offset("error_address")),
        ("i32.const", FAILED),
    ]  # fmt: skip
