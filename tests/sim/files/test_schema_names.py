"""Unknown names in documents, for all forms of declarations in the schemas."""

from __future__ import annotations

from pathlib import Path

import pytest
from lxml import etree

from crs_cc.sim.files.schema_names import unknown_names
from crs_cc.sim.files.xml_document import schema_document

ROOT = Path(__file__).parents[3]
SIM = ROOT / "crs_cc" / "sim"
FILES = [
    *((path, "world.xsd") for path in sorted((ROOT / "worlds").glob("*.xml"))),
    *((path, "robot.xsd") for path in sorted((SIM / "files" / "robots").glob("*.xml"))),
]


@pytest.mark.parametrize(("path", "schema"), FILES, ids=lambda each: Path(each).stem)
def test_valid_documents_have_no_unknown_names(path: Path, schema: str) -> None:
    parser = etree.XMLParser(remove_comments=True)
    document, known = etree.parse(path, parser), schema_document(schema)
    assert list(unknown_names(document.getroot(), known.getroot())) == []
