"""Programs of a world that is edited are checked in the background."""

from __future__ import annotations

import os
import threading
from pathlib import Path

import pytest

from crs_cc.sim.files.world_xml import load_world
from crs_cc.workbench.program_checks import ProgramChecks

WORLD = """<world version="1"><area length="9m" width="9m"/>
  <robot id="good" x="1m" y="1m" program="good.c"/>
  <robot id="bad" x="3m" y="1m" program="bad.c"/>
  <robot id="worse" x="5m" y="1m" program="bad.c"/>
  <robot id="none" x="7m" y="1m"/>
</world>
"""


@pytest.mark.usefixtures("forks")
def test_errors_arrive_later_and_are_kept_until_the_file_changes(tmp_path: Path) -> None:
    (tmp_path / "world.xml").write_text(WORLD)
    (tmp_path / "good.c").write_text("int main(void) { return 0; }\n")
    bad = tmp_path / "bad.c"
    bad.write_text("int main(void) { return x; }\n")
    world = load_world(tmp_path / "world.xml")
    told = threading.Event()
    checks = ProgramChecks(told.set)
    assert checks.messages(world) == {}
    assert told.wait(120)
    found = checks.messages(world)
    assert list(found) == ["bad", "worse"]
    assert found["bad"][0]["text"].startswith("use of undeclared identifier 'x'")
    assert found["bad"][0]["line"] == 1
    told.clear()
    assert checks.messages(world) == found
    bad.write_text("int main(void) { return 1; }\n")
    os.utime(bad, ns=(1, 1))
    assert checks.messages(world) == {}
    assert told.wait(120)
    assert checks.messages(world) == {}
    bad.unlink()
    assert checks.messages(world) == {}
    checks.end()
