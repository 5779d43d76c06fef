"""The contents of messages are in a recording, its tables and its page."""

from __future__ import annotations

import csv
from pathlib import Path

from crs_cc.cli.main import main
from crs_cc.recording.message_contents import MessageContents
from crs_cc.recording.recording import Recording
from crs_cc.workbench.message_log import recorded_rows
from crs_cc.workbench.recorded_content import events_in

PROGRAM = r"""
#include <crs.h>
#include <Nclient.h>
#include <string.h>

int main(void)
{
    struct crs_message message;
    char *words[] = {"go", "=1+1", "\377\1"};
    int i;

    connect_robot(crs_my_number() + 1);
    for (i = 0; i < 3; i++) {
        crs_send(1 - crs_my_number(), 7, words[i], strlen(words[i]));
        crs_receive(&message, 1000);
    }
    return 0;
}
"""


def test_message_contents_are_recorded_and_shown_with_each_outcome(
    tmp_path: Path,
) -> None:
    program, path = tmp_path / "talk.c", tmp_path / "run.mcap"
    program.write_text(PROGRAM)
    world = str(Path(__file__).parents[2] / "worlds" / "pair.xml")
    assert main(["run", str(program), world, "--record", str(path), "--quiet"]) == 0
    recording = Recording(path)
    contents = MessageContents()
    rows = [
        row
        for _, entry in recording.data("/crs/message")
        for row in recorded_rows(entry, {"sent": 0, "delivered": 1}, contents)
    ]
    words = ["go", "=1+1", "\\xff\\x01"]
    for fate in (0, 1):
        assert [row[-1] for row in rows if row[1] == fate and row[3] == 0] == words
    texts = [text for _, kind, _, text, *_ in events_in(recording)[0] if kind == "message-sent"]
    assert "robot0 to robot1: sent 'go'" in texts
    recording.close()
    assert main(["replay", str(path), "--csv", str(tmp_path)]) == 0
    with (tmp_path / "messages.csv").open(newline="", encoding="utf-8") as file:
        said = [(row["content"], row["content [hex]"]) for row in csv.DictReader(file)]
    assert set(said) == {("go", "676f"), ("'=1+1", "3d312b31"), ("\\xff\\x01", "ff01")}
