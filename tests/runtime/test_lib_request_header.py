"""`crs_request.h` and `crs_cc.requests` describe the same interface."""

from __future__ import annotations

import re
from pathlib import Path

import crs_cc.runtime
from crs_cc.requests import CODES, DATA_SIZE, ERROR_KINDS, MESSAGE, REQUESTS
from crs_cc.sim.model.registry import devices

LIBRARY = Path(crs_cc.runtime.__file__).parent / "lib"
HEADER = (LIBRARY / "include" / "crs_request.h").read_text()
SIZES = {"int": 4, "double": 8, "unsigned char": 1}


def message_members() -> dict[str, tuple[int, int]]:
    """Return (offset, size) of each member, as the C compiler lays `struct __crs_message` out."""
    body = re.search(r"struct __crs_message \{(.*?)\n\};", HEADER, re.DOTALL)
    assert body is not None
    members, offset = {}, 0
    for kind, name, count in re.findall(
        r"(int|double|unsigned char) (\w+)(?:\[(\d+)\])?;", body[1]
    ):
        assert offset % SIZES[kind] == 0, f"{name} would be padded"
        members[name] = (offset, SIZES[kind] * int(count or 1))
        offset += members[name][1]
    return members


def test_message_has_the_layout_that_numpy_sees() -> None:
    assert MESSAGE.fields is not None
    expected = {name: (field[1], field[0].itemsize) for name, field in MESSAGE.fields.items()}
    assert message_members() == expected
    assert sum(size for _, size in message_members().values()) == MESSAGE.itemsize == 320


def test_every_code_has_its_number() -> None:
    defined = {name: int(code) for name, code in re.findall(r"#define CRS_(\w+) (\d+)", HEADER)}
    assert defined.pop("DATA_SIZE") == DATA_SIZE
    of_devices = {request.name for device in devices() for request in device.requests}
    assert defined == {name: code for name, code in CODES.items() if name not in of_devices}


def test_library_stops_programs_with_known_error_kinds() -> None:
    sources = [path.read_text() for path in LIBRARY.rglob("*.c")]
    kinds = {kind for text in sources for kind in re.findall(r'__crs_stop\("([^"]*)"[,)]', text)}
    assert kinds
    assert kinds <= set(ERROR_KINDS)


# Functions that take State out of a reply, with the code as their first argument.
READERS = (
    "__crs_command", "__crs_post_state", "__crs_read_group", "__crs_read_sensors", "command",
    "axes", "exchange", "magnitudes", "wheels",
)  # fmt: skip


def test_state_is_taken_from_replies_that_hold_it() -> None:
    sources = [path.read_text() for path in sorted((LIBRARY / "robot").glob("*.c"))]
    calls = rf"\b(?:{'|'.join(READERS)})\(CRS_(\w+)"
    read = {name for source in sources for name in re.findall(calls, source)}
    assert {"GS", "MV", "WS", "CONF_SN", "CT", "GET_RC"} <= read
    assert {name for name in read if not REQUESTS[CODES[name]].replies_state} == set()
