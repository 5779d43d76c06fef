"""Short ranges are copied and filled inline, with the same results and checks as long ones."""

from __future__ import annotations

from pathlib import Path

import pytest

from crs_cc.core.source import Diagnostics
from crs_cc.runtime.codegen.inline_ranges import MAX_COPIED, words
from crs_cc.session.build import build_executable
from crs_cc.session.session import Session
from crs_cc.sim.files.world_xml import parse_world
from tests.c.execution import Run

SIZES = [1, 2, 3, 5, 7, 8, 9, 15, 16, 17, 31, 63, 64, 65, 255, 256, 257]


@pytest.mark.parametrize("size", [*range(1, 70), 255, 256])
def test_words_cover_a_range_and_nothing_else(size: int) -> None:
    step, offsets = words(size)
    covered = {at + byte for at in offsets for byte in range(step)}
    assert covered == set(range(size))


def _exit_status(folder: Path, body: str, *, checked: bool = True) -> int | None:
    source = folder / "ranges.c"
    source.write_text(f"#include <string.h>\nint main(void) {{ {body} }}\n")
    outcome = Run(build_executable([source], Diagnostics(), checked=checked)).to_end()
    assert outcome.failure is None
    return outcome.status


@pytest.mark.parametrize("checked", [True, False])
def test_a_range_that_overlaps_itself_is_moved_as_a_whole(tmp_path: Path, checked: bool) -> None:
    moves = "".join(
        f"for (i = 0; i < 600; i++) a[i] = b[i] = i * 7;"
        f"memmove(a + {by}, a, {size});"
        f"for (i = 0; i < {size}; i++) bad += a[i + {by}] != b[i];"
        for size in SIZES
        for by in (1, 3, 8)
    )
    body = f"static unsigned char a[600], b[600]; int i, bad = 0; {moves} return bad != 0;"
    assert _exit_status(tmp_path, body, checked=checked) == 0


@pytest.mark.parametrize("checked", [True, False])
def test_a_fill_sets_its_range_and_nothing_else(tmp_path: Path, checked: bool) -> None:
    fills = "".join(
        f"for (i = 0; i < 300; i++) a[i] = 1; memset(a + 5, -2, {size});"
        f"for (i = 0; i < 300; i++) bad += a[i] != (i >= 5 && i < 5 + {size} ? 254 : 1);"
        for size in SIZES
    )
    body = f"static unsigned char a[300]; int i, bad = 0; {fills} return bad != 0;"
    assert _exit_status(tmp_path, body, checked=checked) == 0


@pytest.mark.parametrize("size", [size for size in SIZES if size <= MAX_COPIED])
@pytest.mark.parametrize("access", ["read", "write"])
def test_a_copy_names_the_first_byte_outside(tmp_path: Path, size: int, access: str) -> None:
    source = tmp_path / "outside.c"
    order = "good, bad" if access == "write" else "bad, good"
    source.write_text(f"""
        #include <stdlib.h>
        struct part {{ char bytes[{size}]; }};
        int main(void)
        {{
            struct part *good = calloc(2, {size}), *bad = malloc({size});
            bad = (struct part *) ((char *) bad + {size} / 2 + 1);
            *{order.split(", ")[1]} = *{order.split(", ", maxsplit=1)[0]};
            return 0;
        }}""")
    failure = Run(build_executable([source], Diagnostics())).to_end().failure
    assert failure is not None
    assert (failure.kind, failure.access, failure.size) == ("out of bounds", access, size)
    assert failure.object is not None
    assert failure.value == failure.object.address + size


@pytest.mark.parametrize("distance", [8, 12, 64])
def test_a_copy_from_the_last_addresses_names_its_first_byte(tmp_path: Path, distance: int) -> None:
    source = tmp_path / "last.c"
    source.write_text(f"""
        struct part {{ char bytes[64]; }} all;
        int main(int argc, char **argv) {{ all = *(struct part *) (-{distance} * argc); return 0; }}
        """)
    failure = Run(build_executable([source], Diagnostics())).to_end().failure
    assert failure is not None
    assert (failure.kind, failure.value) == ("pointer outside memory", 2**32 - distance)


@pytest.mark.parametrize("distance", [8, 16, 100])
def test_a_message_at_the_last_addresses_names_its_first_byte(
    tmp_path: Path, distance: int
) -> None:
    source = tmp_path / "post.c"
    source.write_text(f"""
        #include <crs_request.h>
        int main(int argc, char **argv)
        {{
            return __crs_request(CRS_VM, (struct __crs_message *) (-{distance} * argc));
        }}
        """)
    failure = Run(build_executable([source], Diagnostics())).to_end().failure
    assert failure is not None
    assert (failure.kind, failure.value) == ("pointer outside memory", 2**32 - distance)


def test_a_long_fill_names_the_first_byte_outside(tmp_path: Path) -> None:
    """Whichever of the bytes that are checked together it is."""
    source = tmp_path / "long.c"
    source.write_text("""
        #include <stdlib.h>
        #include <string.h>
        int main(int argc, char **argv)
        {
            char *bytes = malloc(200);
            return memset(bytes + atoi(argv[1]), 7, 150) == 0;
        }""")
    starts = range(48, 88)
    robots = "".join(f'<robot x="{start}m" y="1m"/>' for start in starts)
    world = f'<world version="1"><area length="99m" width="2m"/>{robots}</world>'
    session = Session(
        parse_world(world.encode(), "row.xml"),
        [build_executable([source], Diagnostics())] * len(starts),
        arguments=[["long", str(start)] for start in starts],
    )
    session.step()
    for robot, start in enumerate(starts):
        if start + 150 <= 200:
            assert session.result().robots[robot].exit_status == 0
            continue
        failure = session.fleet.failure(robot)
        assert (failure.kind, failure.size) == ("out of bounds", 150)
        assert failure.object is not None
        assert failure.value == failure.object.address + 200


def test_a_long_fill_at_the_last_addresses_names_its_first_byte(tmp_path: Path) -> None:
    source = tmp_path / "last.c"
    source.write_text("""
        #include <string.h>
        int main(int argc, char **argv) { return memset((char *) (-24 * argc), 7, 40) == 0; }
        """)
    failure = Run(build_executable([source], Diagnostics())).to_end().failure
    assert failure is not None
    assert (failure.kind, failure.value) == ("pointer outside memory", 2**32 - 24)
    assert failure.size == 40
