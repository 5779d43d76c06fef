"""Every request has a handler, units, and a function that posts it."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

import crs_cc.runtime
from crs_cc.requests import REQUESTS, RequestCode
from crs_cc.session.host import HOST_CODES, Host, discard, no_input
from crs_cc.sim.engine.handlers import HANDLERS

INCLUDE = Path(crs_cc.runtime.__file__).parent / "lib" / "include"
HEADERS = "\n".join(path.read_text() for path in sorted(INCLUDE.rglob("*.h")))


@pytest.mark.parametrize("request_code", REQUESTS.values(), ids=lambda each: each.name)
def test_every_request_is_answered_and_described(request_code: RequestCode) -> None:
    host = Host([[]], discard, no_input)
    answered_by_host = request_code.code in host._serve
    assert answered_by_host == (request_code.server == "host")
    assert answered_by_host != (request_code.code in HANDLERS)
    for argument in (*request_code.arguments, *request_code.results):
        assert argument.unit, argument.name
    function = re.search(r"(\w+)\(", request_code.prototype)
    assert function is not None
    if function[1] != "main":
        declaration = rf"^\w[\w *]*\b{function[1]}\([^;{{]*\);"
        assert re.search(declaration, HEADERS, re.MULTILINE), function[1]


def test_the_host_rejects_other_requests() -> None:
    assert set(Host([], discard, no_input)._serve) == HOST_CODES
