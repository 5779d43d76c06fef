"""Hosts in the environment's own process, whose programs come from other machines."""

from __future__ import annotations

from base64 import b64encode

import numpy as np
import pytest

from crs_cc.cli.own_hosts import OwnHosts
from crs_cc.core.errors import CompileError
from crs_cc.net.handshake import Program


@pytest.mark.parametrize(
    ("name", "text", "error"),
    [("/../a.c", "", ValueError), ("/home/a.c", "int main(void) { return x; }", CompileError)],
    ids=["outside", "invalid"],
)
def test_programs_that_cannot_be_compiled_here_are_rejected(
    name: str, text: str, error: type[Exception]
) -> None:
    files = {name: b64encode(text.encode()).decode()}
    own = OwnHosts(["left"], to_stderr=False, threads=1)
    with pytest.raises(error):
        own.start(Program("a.c", "a", sources=(name,), files=files), np.array([0]))
    own.close()
