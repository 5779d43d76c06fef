"""Every call of the vendor's API, compared with recordings of the vendor's compiled libraries.

`vendor/` has two programs that make every call and print what each returned and which elements of
`State` it overwrote, and what they printed when they were linked with Nclient 2.7 and Ndirect 2.7.
These spoke to a server, or to a robot on a serial line, that answered everything with fixed
numbers; here a simulated robot answers.
"""

import difflib
from pathlib import Path

import pytest

from crs_cc.cli.main import main

RECORDED = Path(__file__).parent / "vendor"

SAID = "hello"
"""The robot's words, which ours writes to standard output."""

LINE = ("(38400 baud using /dev/pts/2)", "(38400 baud using /dev/ttyS0)")
NO_DEVICE = ("", "Nak")
"""No device answers the packet of the user's own."""


def differences(recorded: str, shown: str) -> list[tuple[str, str]]:
    """Return the lines in which two texts differ, "" for a line that is missing."""
    left, right = recorded.splitlines(), shown.splitlines()
    found = []
    for kind, a, b, c, d in difflib.SequenceMatcher(None, left, right, False).get_opcodes():
        if kind != "equal":
            size = max(b - a, d - c)
            theirs, ours = left[a:b] + [""] * size, right[c:d] + [""] * size
            found += list(zip(theirs[:size], ours[:size], strict=True))
    return found


def run(capfd: pytest.CaptureFixture[str], program: Path, *options: str) -> str:
    assert main(["run", "-q", *options, str(program)]) == 0
    return capfd.readouterr().out


def test_nclient_does_with_every_call_what_the_vendors_does(
    capfd: pytest.CaptureFixture[str],
) -> None:
    shown = run(capfd, RECORDED / "every_call.c", "--robot", "nomad200")
    path = "motion_check(0, 0., 0., 1., 1., 0., 0., 0., col)"
    assert differences((RECORDED / "nclient-2.7.txt").read_text(), shown) == [
        ("", SAID),
        (f"{path}      1 ", f"{path}      0 "),  # whether there is a collision
        # Nobody points at a place in the window, and no device knows the packet.
        ("get_robot_conf(conf)        1 ", "get_robot_conf(conf)        0  44  [44]=1"),
        ("special_request(sb, rb)      1 ", "special_request(sb, rb)      0  44  [44]=1"),
        # After quit_server, a write to the closed connection kills the vendor's program.
        ("", "disconnect_robot(1)         0  44  [44]=111"),
    ]


def test_ndirect_does_with_every_call_what_the_vendors_does(
    capfd: pytest.CaptureFixture[str],
) -> None:
    shown = run(capfd, RECORDED / "every_call_direct.c", "--client", "ndirect")
    recorded = (RECORDED / "ndirect-2.7-scout.txt").read_text()
    assert differences(recorded, shown) == [LINE, NO_DEVICE, LINE]


def test_ndirect_does_on_a_nomad_200_what_the_vendors_does(
    capfd: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    text = (RECORDED / "every_call_direct.c").read_text()
    program = tmp_path / "every_call.c"
    program.write_text(
        text.replace("MODEL_SCOUT", "MODEL_N200").replace(
            "connect_robot(1, 2,", "connect_robot(1, 0,"
        )
    )
    shown = run(capfd, program, "--client", "ndirect", "--robot", "nomad200")
    score = "compass calibration score x: {} y: {} z: {}"
    assert differences((RECORDED / "ndirect-2.7-n200.txt").read_text(), shown) == [
        LINE,
        (score.format(1, 2, 3), score.format(0, 0, 0)),
        # The recorded robot has no laser.
        ("Nak", "get_ls()                    1   laser"),
        ("get_ls()                    1 ", "get_sg()                    1   laser"),
        ("Nak", SAID),
        ("get_sg()                    1 ", ""),
        NO_DEVICE,
        LINE,
    ]


def test_ndirect_has_no_port_and_leaves_a_masked_element(
    capfd: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    program = tmp_path / "masked.c"
    program.write_text("""#include <stdio.h>
        #include <Nclient.h>
        int main(void) {
            printf("%d", SERV_TCP_PORT);
            connect_robot(1, MODEL_N200, "/dev/ttyS0", 38400);
            Smask[SMASK_SONAR_1] = 0; ct();
            State[STATE_SONAR_0] = State[0] = State[42] = -5; gs();
            printf(" %ld %ld %ld\\n", State[STATE_SONAR_0], State[0], State[42]);
            return 0;
        }""")
    options = ("--robot", "nomad200")
    shown = run(capfd, program, *options, "--client", "ndirect")
    assert shown.startswith("-1")
    assert shown.endswith(" -5 -5 -5\n")
    shown = run(capfd, program, *options)
    assert shown.startswith("7019 255 ")
