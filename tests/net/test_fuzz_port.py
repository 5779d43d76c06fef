"""A short run of `tests.net.fuzz_port`, after which hosts can still connect."""

from __future__ import annotations

import random

from tests.net.fuzz_port import Fuzzer
from tests.net.test_listener import Open, wait_until_ready


def test_invalid_connections_receive_nothing_and_do_not_affect_the_run() -> None:
    opened = Open()
    fuzzer = Fuzzer(opened.listener.port, random.Random(3), (0.001, 0.02))
    with opened.keep_alive:
        for _ in range(200):
            fuzzer.throw()
        opened.join("left", "right")
        wait_until_ready(opened, "left", "right")
    opened.listener.close()
    assert set(fuzzer.answers) == {"none yet", "closed", "503", "REFUSED"}
