"""A moment of what `tests.net.fuzz_port` does for minutes; and hosts still come in."""

from __future__ import annotations

import random

from tests.net.fuzz_port import Fuzzer
from tests.net.test_gate import Open, wait_until_ready


def test_nonsense_on_the_port_gets_nothing_and_disturbs_nobody() -> None:
    opened = Open()
    fuzzer = Fuzzer(opened.gate.port, random.Random(3), (0.001, 0.02))
    with opened.pulse:
        for _ in range(200):
            fuzzer.throw()
        opened.visit("left", "right")
        wait_until_ready(opened, "left", "right")
    opened.gate.close()
    assert set(fuzzer.answers) == {"none yet", "closed", "503", "REFUSED"}
