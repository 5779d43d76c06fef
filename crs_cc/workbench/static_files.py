"""The files of the page, each at one address: no request names a path."""

from __future__ import annotations

import json
from base64 import b64encode
from dataclasses import dataclass
from functools import cache
from hashlib import sha256
from pathlib import Path
from typing import Final

FOLDER: Final = Path(__file__).parent / "static"
MODULES: Final = tuple(
    name
    for name in sorted(path.relative_to(FOLDER).as_posix() for path in FOLDER.rglob("*.js"))
    if not name.startswith(("three/", "builder/"))
)
"""The modules of the page of a run, by their names after `crs/`."""

STYLES: Final = ("style.css", "panel.css")
"""The style sheets, in their order."""

_TYPES: Final = {".html": "text/html", ".js": "text/javascript", ".css": "text/css"}
_IMPORTS: Final = json.dumps(
    {
        "imports": {
            "crs/": "/static/",
            "three": "/static/three/three.module.js",
        }
    }
)
_HASH: Final = b64encode(sha256(_IMPORTS.encode()).digest()).decode()
POLICY: Final = (
    f"default-src 'none'; script-src 'self' 'sha256-{_HASH}'; style-src 'self'; "
    "connect-src 'self'; img-src 'self' data: blob:; media-src blob:; base-uri 'none'; "
    "form-action 'none'; "
    "frame-ancestors vscode-webview: vscode-file: http://127.0.0.1:* http://localhost:*"
)
"""What the page may load: nothing but itself. Windows of VS Code may frame it, in a browser of this
machine, too; they must know the token. Pages of other machines may not."""


@dataclass(frozen=True, slots=True)
class StaticFile:
    """A file as it is sent."""

    content: bytes
    type: str


def html(*, head: str, start: str, imports: str, run: str = "") -> str:
    """Return the page.

    Args:
        head: what its head has besides: style and policy.
        start: the element that starts it.
        imports: its import map.
        run: the recorded run that it holds, as JSON; empty to ask a server.
    """
    page = (FOLDER / "page.html").read_text("utf-8")
    page = page.replace("@HEAD@", head).replace("@START@", start)
    return page.replace("@MODULES@", imports).replace("@RUN@", run)


@cache
def file_at(path: str) -> StaticFile | None:
    """Return the file at an address; None if there is none."""
    found = _addresses().get(path)
    if found is None:
        return None
    if found.suffix == ".html":
        is_builder = path == "/build"
        styles = (*STYLES, "builder/builder.css") if is_builder else STYLES
        head = "".join(f'<link rel="stylesheet" href="/static/{name}">' for name in styles)
        folder = "/static/builder" if is_builder else "/static"
        start = f'<script type="module" src="{folder}/app.js"></script>'
        page = html(head=head, start=start, imports=_IMPORTS)
        return StaticFile(page.encode(), _TYPES[".html"])
    return StaticFile(found.read_bytes(), _TYPES[found.suffix])


@cache
def _addresses() -> dict[str, Path]:
    found = {"/": FOLDER / "page.html", "/build": FOLDER / "page.html"}
    for path in FOLDER.rglob("*"):
        if path.suffix in {".js", ".css"}:
            found[f"/static/{path.relative_to(FOLDER).as_posix()}"] = path
    return found
