"""The user's settings and command history from earlier sessions at a terminal."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from crs_cc.debug.commands.context import CommandContext
from crs_cc.debug.commands.user_files import history_file, read_lines, settings_file, write_lines


class UserSession:
    """A session of a user at a terminal.

    Attributes:
        commands: the commands of earlier sessions, the last one last.
    """

    def __init__(self, context: CommandContext) -> None:
        """Read the stored settings and commands."""
        self._context = context
        path = history_file()
        self.commands = read_lines(path) if path is not None else []

    def load_settings(self) -> Iterator[str]:
        """Take over the settings; return a message for each line of their file that is invalid."""
        path = settings_file()
        if path is not None:
            yield from self._context.settings.load(path)
            self._context.apply_settings()

    def keep_settings(self) -> None:
        """Keep the settings that are changed from now on."""
        self._context.settings.save_to(settings_file())

    def keep_commands(self, typed: Sequence[str]) -> None:
        """Store the commands of this session after those of sessions that have ended since."""
        path, settings = history_file(), self._context.settings
        if path is not None and typed and settings["history save"]:
            lines = [*read_lines(path), *typed]
            write_lines(path, lines[max(0, len(lines) - settings["history size"]) :])
