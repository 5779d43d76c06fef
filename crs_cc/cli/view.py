"""`crs view`: the command and its options; `start_view` does the work."""

from __future__ import annotations

import functools
from pathlib import Path
from typing import Any, Final
from urllib.parse import urlsplit

import click

from crs_cc.cli.inputs import check_recording_path
from crs_cc.cli.messages import say
from crs_cc.cli.page_options import page_options
from crs_cc.cli.program_options import WithProgramArguments, program_options
from crs_cc.cli.record_options import record_options
from crs_cc.cli.time_options import MAX_TIME
from crs_cc.cli.view_address import address_of, is_address

_ADDRESSES: Final = "crs_cc.addresses"
_ANSWER_S: Final = 2.0
"""Timeout for the process that serves a run [s]."""

_EXAMPLES: Final = """
\b
Examples:
  crs view wander.c room.xml                     watch, control and debug a run
    crs view wander.c room.xml --play              start at once
  crs view run.mcap                              view a recorded run
  crs view new.mcap --compare old.mcap           where two recorded runs differ
  crs view wander.c room.xml --compare old.mcap  where a run differs from a recorded one
  crs view wander.c room.xml --no-open           print the address only
  crs view 127.0.0.1:8700                        another page of a run that is served there
  crs view procyon:8000 --token TOKEN            a run of crs serve on another machine
"""


class _View(WithProgramArguments):
    """Sets the address of a run aside, which is no file."""

    def parse_args(self, ctx: click.Context, args: list[str]) -> list[str]:
        """Set the address aside, and parse the others."""
        own = args[: args.index("--")] if "--" in args else args
        ctx.meta[_ADDRESSES] = [word for word in own if is_address(word)]
        return super().parse_args(ctx, [word for word in args if not is_address(word)])


@click.command(
    cls=_View,
    epilog=_EXAMPLES,
    short_help="Watch, control and debug a run in the browser.",
    options_metavar="[OPTIONS]",
)
@page_options
@MAX_TIME
@click.option("--play", is_flag=True, help="Start at once, without a click.")
@click.option(
    "--input",
    metavar="FILE",
    type=click.Path(exists=True, dir_okay=False, path_type=Path),
    help="Send each line of FILE to the programs at the simulated time given at the start "
    "of the line, as in crs run.",
)
@click.option(
    "--stdin",
    metavar="FILE",
    type=click.Path(exists=True, dir_okay=False, path_type=Path),
    help="File to use as the programs' standard input. Default: none.",
)
@click.option(
    "--compare",
    "compared",
    metavar="RECORDING",
    multiple=True,
    type=click.Path(exists=True, dir_okay=False, path_type=Path),
    help="Compare the run with a recorded one, which is drawn beside it; may be repeated.",
)
@record_options
@click.option("-q", "--quiet", is_flag=True, help="Suppress compiler warnings.")
@functools.partial(program_options, needs_files=False)
@click.option(
    "--token",
    metavar="TOKEN",
    help="The token for viewing a run of crs serve on another machine.",
)
def view(
    port: int,
    *,
    opens: bool,
    play: bool,
    compared: tuple[Path, ...],
    token: str | None,
    **options: Any,
) -> int:
    """Compile a C control program and watch it in the browser.

    The page shows the world, the robots and the source line that each program is executing. It
    plays, pauses and rewinds the run, and steps through the programs forward and backward. It is
    served to this machine only; anyone who has the printed URL can control the run. Press Ctrl-C to
    end it. --record records the run in its final form, with all changes. crs run --view shows a run
    that starts without waiting for the page.
    """
    from crs_cc.cli.debug_options import DebugOptions  # not needed for other commands
    from crs_cc.cli.start_view import view_programs
    from crs_cc.cli.view_recording import view_recording

    wanted = DebugOptions(**options)
    for address in click.get_current_context().meta[_ADDRESSES]:
        return _open(address, token, opens=opens)
    if wanted.record is not None:
        check_recording_path(wanted.record)
    sources = wanted.inputs.sources
    if not sources and wanted.inputs.world is None:
        raise click.UsageError("no C file, recording or HOST:PORT of a run to view.")
    if any(path.suffix.lower() == ".mcap" for path in sources):
        if len(sources) > 1 or wanted.inputs.world is not None or wanted.arguments:
            hint = "to see two side by side: crs view ONE.mcap --compare OTHER.mcap"
            raise click.UsageError(f"a recording has its own programs and world; {hint}.")
        if wanted.max_time_s is not None:
            raise click.UsageError("--max-time applies to programs, not to recordings.")
        return view_recording(sources[0], compared, port, opens=opens, plays=play)
    return view_programs(wanted, compared, port, opens=opens, plays=play)


def _open(word: str, token: str | None, *, opens: bool) -> int:
    """Open one more page of a run that is shown already; return the exit status.

    Args:
        word: where it is shown, see `address_of`.
        token: shows that we may look.
        opens: whether the browser is opened.
    """
    from crs_cc.cli.start_view import open_browser
    from crs_cc.net.tls import fingerprint_at

    address = address_of(word, token)
    at, fingerprint, warning = urlsplit(address), "", ""
    try:
        fingerprint = fingerprint_at((at.hostname or "", at.port or 443), _ANSWER_S)
    except OSError as error:
        reason = error.strerror or error
        warning = f"crs: warning: no run is served at {at.hostname}:{at.port} now: {reason}"
    if fingerprint:
        address = at._replace(scheme="https").geturl()
    elif at.scheme == "https" and not warning:
        warning = f"crs: warning: {at.hostname}:{at.port} is not encrypted"
    say(f"crs: open {address}")
    if fingerprint:
        say(f"crs: fingerprint of the certificate: {fingerprint}")
    if warning:
        say(warning)
    if opens:
        open_browser(address)
    return 0
