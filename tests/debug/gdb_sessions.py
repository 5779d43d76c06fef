"""Executed by gdb: run sessions of commands, and write what was seen as JSON.

    gdb -nx -batch -ex "python SESSIONS, SEEN = 'in.json', 'out.json'" -x gdb_sessions.py PROGRAM

A session is a list of commands. What is seen is, for each of them, where the program stands (the
function and the line, or nothing) and what the command answers.
"""

import json
from pathlib import Path

import gdb


def place():
    """Return the function and line of the selected frame; None if nothing runs."""
    try:
        frame = gdb.selected_frame()
    except gdb.error:
        return None
    return [frame.name(), frame.find_sal().line]


def run(session):
    """Return what is seen in a session."""
    gdb.execute("delete")
    if place() is not None:
        gdb.execute("kill", to_string=True)
    seen = []
    for command in session:
        try:
            answer = gdb.execute(command, to_string=True)
        except gdb.error as error:
            answer = f"error: {error}"
        seen.append([place(), answer])
    return seen


for setting in ("confirm", "pagination", "startup-with-shell", "debuginfod enabled"):
    gdb.execute(f"set {setting} off")
names = globals()
sessions = json.loads(Path(names["SESSIONS"]).read_text())
Path(names["SEEN"]).write_text(json.dumps([run(each) for each in sessions]))
