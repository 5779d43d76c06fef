"""The types that the page's modules say in their comments, checked by TypeScript."""

from __future__ import annotations

import json
import subprocess
from pathlib import Path

from crs_cc.workbench.static_files import FOLDER
from tests.npm_packages import installed

NODE = Path(__file__).with_name("node")
THREE = "declare const three: any;\nexport = three;\n"


def settings(folder: Path) -> dict[str, object]:
    return {
        "compilerOptions": {
            "allowJs": True,
            "checkJs": True,
            "noEmit": True,
            "strict": False,
            "types": [],
            "target": "es2023",
            "lib": ["es2023", "dom", "dom.iterable"],
            "module": "esnext",
            "moduleResolution": "bundler",
            "paths": {"crs/*": [f"{FOLDER}/*"], "three": [f"{folder}/three.d.ts"]},
        },
        "include": [f"{FOLDER}/**/*.js"],
        "exclude": [f"{FOLDER}/three"],
    }


def test_the_modules_of_the_page_have_the_declared_types(tmp_path: Path) -> None:
    modules = installed(NODE)
    (tmp_path / "three.d.ts").write_text(THREE)
    (tmp_path / "tsconfig.json").write_text(json.dumps(settings(tmp_path)))
    tsc = [str(modules / ".bin" / "tsc"), "--project", str(tmp_path), "--pretty", "false"]
    done = subprocess.run(tsc, capture_output=True, text=True, timeout=120, check=False)
    assert done.stdout == ""
    assert done.returncode == 0
