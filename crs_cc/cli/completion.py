"""`crs completion`: scripts with which shells complete the command line of crs."""

from __future__ import annotations

from typing import Final

import click

_EXAMPLES: Final = """
\b
Examples:
  crs completion bash >> ~/.bashrc
  crs completion zsh >> ~/.zshrc
  crs completion fish > ~/.config/fish/completions/crs.fish
"""
VARIABLE: Final = "_CRS_COMPLETE"
"""The variable with the instruction of such a script, as click expects it for the command `crs`."""


@click.command(epilog=_EXAMPLES, short_help="Print a shell completion script.")
@click.argument("shell", type=click.Choice(["bash", "zsh", "fish"]))
@click.pass_context
def completion(context: click.Context, shell: str) -> int:
    """Print a script for shell completion of crs commands, options and file names."""
    from click.shell_completion import get_completion_class

    made = get_completion_class(shell)
    assert made is not None
    script = made(context.find_root().command, {}, "crs", VARIABLE)
    click.echo(script.source_template % script.source_vars())
    return 0
