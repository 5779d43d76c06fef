"""Write all generated pages, and the manifest of the VS Code extension."""

from __future__ import annotations

from docs.generate import man, page_names, page_path, page_text
from docs.generate.editors import EXTENSION, extension_text

for name in page_names():
    page_path(name).write_text(page_text(name), encoding="utf-8")
EXTENSION.write_text(extension_text(), encoding="utf-8")
man.MAN.mkdir(exist_ok=True)
for name, text in man.pages().items():
    (man.MAN / name).write_text(text, encoding="utf-8")
