"""`crs serve`: the command and its options; `start_serve` does the work."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from importlib.util import find_spec
from pathlib import Path
from typing import Any, Final, Literal

import click
from click.core import ParameterSource

from crs_cc.cli.cluster_options import cluster_options
from crs_cc.cli.compiler_options import CompilerOptions, compiler_options
from crs_cc.cli.inputs import (
    Inputs,
    check_recording_path,
    make_folder,
    parse_named_files,
    sort_files,
)
from crs_cc.cli.net_address import parse_address
from crs_cc.cli.path_options import written_folder
from crs_cc.cli.program_options import (
    READS,
    SEED,
    WRITES,
    WithProgramArguments,
    program_arguments,
    robot_options,
)
from crs_cc.cli.record_options import record_options
from crs_cc.cli.serve_options import ServeOptions
from crs_cc.cli.time_options import MAX_TIME, SPEED
from crs_cc.cli.vendor_options import vendor_options

_EXAMPLES: Final = """
\b
Examples:
  crs serve complex-3r.xml                               for hosts on this machine
  crs serve complex-3r.xml --listen 0.0.0.0:8000 --insecure
  crs serve complex-3r.xml --record run.mcap --max-time 60
  crs serve complex-3r.xml --nserver 7019                for programs linked with Nclient
  crs serve wander.c hall.xml --hosts dask://hall:8786   with hosts on a cluster
  crs join robot0 procyon:8000 prog.c                    a robot's program, on any machine
"""


_FOR_HOSTS: Final = (
    *("listen", "tokens", "tls", "tls_cert", "tls_key", "only_tcp", "start", "on_loss"),
    *("resume", "hosts", "per_host"),
)


def _serve_vendor(options: ServeOptions) -> int:
    """Serve programs that are linked with the vendor's libraries; return the exit status.

    Raises:
        click.UsageError: an option is about hosts, which there are none of.
    """
    from crs_cc.cli.start_vendor import start_vendor

    context = click.get_current_context()
    given = {
        name
        for name in (*_FOR_HOSTS, "speed")
        if context.get_parameter_source(name) is not ParameterSource.DEFAULT
    }
    for name in _FOR_HOSTS:
        if name in given:
            option = f"--{name.replace('_', '-')}"
            raise click.UsageError(f"{option} applies to programs that join, not to the vendor's.")
    return start_vendor(options if "speed" in given else replace(options, speed=1.0))


def _address(_ctx: click.Context, _option: click.Parameter, text: str) -> tuple[str, int]:
    return parse_address(text)


@click.command(
    cls=WithProgramArguments,
    epilog=_EXAMPLES,
    short_help="Serve a world to programs that run on other machines.",
    options_metavar="[OPTIONS]",
)
@click.argument("files", nargs=-1, required=True, metavar="[PROGRAM.c...] WORLD.xml [-- ARGS...]")
@click.option(
    "--listen",
    default="127.0.0.1:8000",
    show_default=True,
    metavar="HOST:PORT",
    callback=_address,
    help="Address to which hosts and viewers connect; port 0 picks a free one. Use 0.0.0.0 to "
    "accept connections from other machines.",
)
@click.option(
    "--tokens",
    type=click.Path(exists=True, dir_okay=False, path_type=Path),
    metavar="FILE",
    help="File of access tokens: each line has a role (robot, view or control) and a token. "
    "Default: new tokens, which are printed.",
)
@click.option(
    "--tls",
    is_flag=True,
    help="Encrypt with a new self-signed certificate; its fingerprint is printed.",
)
@click.option(
    "--tls-cert",
    type=click.Path(exists=True, dir_okay=False, path_type=Path),
    metavar="FILE",
    help="Encrypt with this certificate (PEM).",
)
@click.option(
    "--tls-key",
    type=click.Path(exists=True, dir_okay=False, path_type=Path),
    metavar="FILE",
    help="The private key for the certificate (PEM).",
)
@click.option(
    "--insecure",
    is_flag=True,
    help="Accept connections from other machines without TLS: tokens and programs can be "
    "intercepted.",
)
@click.option(
    "--only-tcp",
    is_flag=True,
    help="Use TCP even for hosts on this machine. By default, hosts run by the same user switch to "
    "a local socket, which is faster, once connected.",
)
@click.option(
    "--start",
    type=click.Choice(["all", "now"]),
    default="all",
    show_default=True,
    help="Start the run when all robots have programs (all) or as soon as one robot has a "
    "program (now); the others then join when their hosts connect, and must "
    "run the same program.",
)
@click.option(
    "--on-loss",
    type=click.Choice(["wait", "stop", "restart"]),
    default="wait",
    show_default=True,
    help="What to do when a host is lost: wait for another host to continue its programs (wait), "
    "stop its programs and hold its robots (stop), or continue its programs in this process "
    "(restart).",
)
@click.option(
    "--resume",
    type=click.Path(exists=True, dir_okay=False, path_type=Path),
    metavar="FILE.mcap",
    help="Continue a run that was killed, from its recording: repeat it up to the end of the "
    "recording, compare its hashes with the recorded ones, and continue. The other options and "
    "programs must be the same.",
)
@click.option(
    "--view/--no-view",
    "shows",
    default=True,
    help="Serve web pages that show the run, on the same port; this is the default. crs view "
    "HOST:PORT opens one. With --no-view, timesteps in which nothing happens are skipped.",
)
@cluster_options
@vendor_options
@MAX_TIME
@SEED
@SPEED
@READS
@WRITES
@robot_options
@record_options
@written_folder(
    "--csv", "Write poses.csv, sensors.csv, events.csv and messages.csv to DIR.", to="tables"
)
@click.option("--json", "as_json", is_flag=True, help="Write the results to stdout as JSON.")
@click.option(
    "--summary/--no-summary",
    default=None,
    help="Print a summary to stderr at the end of the run. Default: only on a terminal.",
)
@click.option(
    "--unchecked", is_flag=True, help="Do not check memory accesses by programs on the cluster."
)
@click.option(
    "--trap-overflow",
    is_flag=True,
    help="Stop a program that runs on the cluster if signed integer arithmetic overflows.",
)
@click.option("-q", "--quiet", is_flag=True, help="Report errors only; no warnings, no summary.")
@compiler_options
def serve(
    *,
    files: tuple[str, ...],
    unchecked: bool,
    named_files: tuple[str, ...],
    outputs: Path | None,
    on_loss: Literal["wait", "stop", "restart"],
    shows: bool,
    **options: Any,
) -> int:
    """Run a world whose robots' programs run on other machines, or in other processes.

    The run starts when crs join has provided a program for each robot. It is bit-for-bit identical
    to one made with crs run, regardless of the number of hosts, their speed, and the order in which
    they connect. Files that programs read and write are on this machine; the programs' output
    appears where they run. The exit status is the same as for crs run.

    With --hosts, programs run on a Dask cluster, and lost hosts are restarted. Give the programs
    before the world file on the command line, or name them in the world file; their standard input
    and output are those of this command.

    With --nserver, --serial or --tcp-robot, all robots are controlled by programs linked with the
    vendor's client libraries, in real time unless --speed is given.
    """
    if outputs is not None:
        make_folder(outputs)
    wanted = ServeOptions(
        inputs=_inputs(files),
        arguments=program_arguments(),
        checked=not unchecked,
        inputs_on_disk=parse_named_files(named_files),
        outputs=outputs,
        on_loss=on_loss,
        view=0 if shows else None,
        **options,
    )
    if wanted.tables is not None:
        make_folder(wanted.tables)
    if wanted.record is not None:
        check_recording_path(wanted.record)
        if wanted.resume is not None and wanted.record.resolve() == wanted.resume.resolve():
            raise click.UsageError("--record and --resume name the same file.")
    if not wanted.hosts:
        _check_has_no_program(wanted)
    elif wanted.start == "now":
        raise click.UsageError("--start now applies to programs that join, not to --hosts.")
    if wanted.vendor:
        return _serve_vendor(wanted)
    from crs_cc.cli.export_run import with_recording

    with with_recording(wanted) as run:
        return _serve_hosts(run)


def _inputs(files: Sequence[str]) -> Inputs:
    inputs = sort_files(files)
    if inputs.world is None:
        raise click.UsageError("no world file (FILE.xml) is given.")
    return inputs


def _check_has_no_program(options: ServeOptions) -> None:
    """Check that programs are named where they are compiled.

    Raises:
        click.UsageError: they are named here, and run elsewhere.
    """
    if options.per_host is not None:
        raise click.UsageError("--per-host requires --hosts.")
    is_compiled = options.compiler != CompilerOptions() or options.trap_overflow
    if options.inputs.sources or options.arguments or is_compiled or not options.checked:
        text = "programs and their options are given to crs join; here, only with --hosts"
        raise click.UsageError(f"{text}.")


def _serve_hosts(options: ServeOptions) -> int:
    """Serve programs on hosts; return the exit status."""
    if not options.hosts:
        from crs_cc.cli.start_serve import start_serve

        return start_serve(options)
    if find_spec("distributed") is None:
        raise click.UsageError("--hosts needs Dask: pip install 'crs_cc[cluster]'.")
    from crs_cc.cli.start_cluster import start_cluster

    context = click.get_current_context()
    if context.get_parameter_source("listen") is ParameterSource.DEFAULT:
        options = replace(options, listen=("", options.listen[1]))
    return start_cluster(options)
