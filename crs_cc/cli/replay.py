"""`crs replay`: the command and its options; other modules do the work."""

from __future__ import annotations

from pathlib import Path
from typing import Any, Final

import click

from crs_cc.cli.inputs import check_plot_path, make_folder
from crs_cc.cli.instants import parse_time
from crs_cc.cli.path_options import written_file, written_folder

_EXAMPLES: Final = """
\b
Examples:
  crs replay run.mcap                            summarise the run
  crs replay run.mcap --at 12.5s                 show the state at a time
  crs replay run.mcap --plot path.svg --csv out  write a picture and tables
  crs replay run.mcap --html run.html            write a page that plays it in a browser
  crs replay run.mcap --verify                   run it again and compare
  crs replay run.mcap --compare other.mcap       show where two runs diverge
  crs replay run.mcap --compare other.mcap --html two.html   the same as a page
  crs replay broken.mcap --recover mended.mcap   write what can be read
  crs debug run.mcap --at 12.5s                  debug the recorded run
"""


@click.command(
    epilog=_EXAMPLES,
    short_help="Show, export, verify, compare or recover recordings.",
    options_metavar="[OPTIONS]",
)
@click.argument("path", type=click.Path(path_type=Path), metavar="RUN.mcap")
@click.option("--at", "at_s", callback=parse_time, metavar="TIME", help="Show the state at TIME.")
@written_file(
    "--plot",
    "Plot the world from above, with each robot's path, to FILE. Its extension selects the "
    "format: .svg for a picture, .gif or .apng for an animation.",
)
@written_folder(
    "--csv", "Write poses.csv, sensors.csv, events.csv and messages.csv to DIR.", to="tables"
)
@written_folder("--arrow", "Write the same tables as Arrow files; needs pyarrow.")
@written_folder("--parquet", "Write the same tables as Parquet files; needs pyarrow.")
@written_file(
    "--html",
    "Write a page that shows the run in any browser, without a network.",
    to="page",
    metavar="FILE.html",
)
@click.option(
    "--verify",
    is_flag=True,
    help="Run the recorded run again and compare its hashes; exit with 125 if they differ.",
)
@click.option(
    "--compare",
    "other",
    type=click.Path(path_type=Path),
    metavar="OTHER.mcap",
    help="Run both recorded runs again up to the first timestep in which robots or global "
    "variables differ, and show how; exit with 125 if they differ. With --html, the page "
    "shows both runs.",
)
@written_file(
    "--recover",
    "Write what can be read of a damaged recording to FILE.mcap.",
    to="mended",
    metavar="FILE.mcap",
)
def replay(path: Path, **options: Any) -> int:
    """Summarise, export, verify, compare or recover a recording.

    Recordings are made by crs run --record. Without options, the run is summarised.
    """
    if options["plot"] is not None:
        check_plot_path(options["plot"])
    for name in ("tables", "parquet", "arrow"):
        if options[name] is not None:
            make_folder(options[name])
    from crs_cc.cli.show_recording import show_recording

    return show_recording(path, **options)
