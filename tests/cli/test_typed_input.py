"""Standard input that is typed at simulated times, and what programs know of it."""

import sys
from pathlib import Path

import click
import pytest

from crs_cc.cli.main import main
from crs_cc.cli.typed_input import parse_script

STEERED = r"""
#include <poll.h>
#include <stdio.h>
#include <sys/ioctl.h>
#include <sys/select.h>
#include <sys/time.h>
#include <unistd.h>

static double now(void)
{
    static struct timeval first;
    struct timeval at;

    gettimeofday(&at, NULL);
    if (first.tv_sec == 0)
        first = at;
    return at.tv_sec - first.tv_sec + (at.tv_usec - first.tv_usec) * 1e-6;
}

static int ready(double seconds)
{
    struct timeval wait = {(int)seconds, (int)((seconds - (int)seconds) * 1e6)};
    fd_set in;

    FD_ZERO(&in);
    FD_SET(0, &in);
    return select(1, &in, NULL, NULL, &wait) && FD_ISSET(0, &in);
}

int main(void)
{
    struct pollfd file = {0, POLLIN, 0};
    char line[80];
    int waiting = -1;

    now();
    printf("%d", ready(0.5));
    printf(" %d", ready(5));
    ioctl(0, FIONREAD, &waiting);
    printf(" at %.2f %d", now(), waiting);
    printf(" %s", fgets(line, sizeof line, stdin));
    printf("%d", poll(&file, 1, 100));
    printf(" %d", poll(&file, 1, -1));
    printf(" at %.2f %c", now(), getchar());
    printf(" %s", fgets(line, sizeof line, stdin));
    printf("at %.2f %d %d\n", now(), ready(0), getchar());
    return 0;
}
"""


@pytest.fixture(autouse=True)
def elsewhere(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    Path("steered.c").write_text(STEERED)


def test_lines_are_typed_at_their_times(capfd: pytest.CaptureFixture[str]) -> None:
    Path("keys.txt").write_text("# forward, then a key\n1s: go\\n\n\n2.5s: w\n 4: x\\x21\\n\n")
    assert main(["run", "steered.c", "--input", "keys.txt"]) == 0
    assert capfd.readouterr().out == "0 1 at 1.00 3 go\n0 1 at 2.50 w x!\nat 4.00 1 -1\n"


def test_a_file_or_pipe_is_ready_at_once(
    capfd: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    Path("in.txt").write_text("go\nwx!\n")
    with Path("in.txt").open() as stream:
        monkeypatch.setattr(sys, "stdin", stream)
        assert main(["run", "steered.c"]) == 0
    assert capfd.readouterr().out == "1 1 at 0.00 3 go\n1 1 at 0.00 w x!\nat 0.00 1 -1\n"


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("go\n", "keys.txt:1: expected a time and a text, as in '2.5s: go\\n'"),
        ("2s: a\n1s: b\n", "keys.txt:2: the time is before that of the previous line"),
    ],
)
def test_a_broken_script_is_rejected_with_its_line(text: str, message: str) -> None:
    with pytest.raises(click.UsageError) as caught:
        parse_script(text, "keys.txt")
    assert caught.value.message == message
