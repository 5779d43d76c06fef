"""Every request has a handler, units, and a function that posts it."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

import crs_cc.runtime
from crs_cc.requests import CODES, MESSAGE, REQUESTS, Request
from crs_cc.runtime.turns import ANSWERED
from crs_cc.session.device_library import device_headers
from crs_cc.session.host import FILE_SERVERS, HANDLERS, HOST_CODES
from crs_cc.session.network.service import _SERVERS, NETWORK_CODES
from crs_cc.sim.engine.environment import Environment
from crs_cc.sim.files.world_xml import empty_world

INCLUDE = Path(crs_cc.runtime.__file__).parent / "lib" / "include"
HEADERS = "\n".join(path.read_text() for path in sorted(INCLUDE.rglob("*.h")))
HEADERS += "\n".join(text for _, text in device_headers())


@pytest.fixture(scope="module")
def environment() -> Environment:
    return Environment(empty_world(), seed=0)


@pytest.mark.parametrize("row", REQUESTS.values(), ids=lambda each: each.name)
def test_every_request_is_answered_and_described(row: Request, environment: Environment) -> None:
    answered_by_host = row.code in HANDLERS | FILE_SERVERS or row.code in ANSWERED
    assert answered_by_host == (row.server == "host")
    assert (row.code in NETWORK_CODES) == (row.server == "network")
    is_of_robot = row.server in ("robot", "device")
    assert is_of_robot == (row.code in environment._data.handlers)
    assert row.waits == (row.code in environment._data.waits)
    for fields in (row.arguments, row.results):
        assert all(field.name.isidentifier() and field.unit for field in fields)
        assert len({field.name for field in fields}) == len(fields)
        assert len({field.place for field in fields}) == len(fields)
        for field in fields:
            array, number = field.position
            size = (MESSAGE[array].shape or (0,))[0] if number >= 0 else 0
            assert -1 <= number < max(size, 1)
    function = re.search(r"(\w+)\(", row.prototype)
    assert function is not None
    if function[1] != "main":
        declaration = rf"^\w[\w *]*\b{function[1]}\([^;{{]*\);"
        assert re.search(declaration, HEADERS, re.MULTILINE), function[1]


def test_the_network_answers_exactly_its_own_requests() -> None:
    assert set(_SERVERS) | {CODES["SOCKET_WAIT"]} == NETWORK_CODES


def test_the_host_rejects_other_requests() -> None:
    assert set(HANDLERS | FILE_SERVERS) == HOST_CODES - ANSWERED
