"""`crs_take`, `crs_drop` and `crs_items` from C, and their counts in results."""

import json

import pytest

from crs_cc.cli.main import main
from crs_cc.recording.recording import Recording
from crs_cc.recording.topics import EVENT
from tests.device.robot import scout_with
from tests.nclient.drive import drive

AREA = 'length="6m" width="6m" origin="centre"'
PLACES = '<source x="0" y="0" items="9"/><nest x="0" y="0"/>'


@pytest.mark.function("crs_take", "crs_drop", "crs_items")
def test_items_are_taken_carried_and_brought(tmp_path):
    program = """
        printf("%d ", crs_items()); printf("%d ", crs_drop());
        printf("%d ", crs_take()); printf("%d ", crs_take()); printf("%d ", crs_items());
        printf("%d ", crs_take()); printf("%d ", crs_drop()); printf("%d", crs_items());
    """
    robot = scout_with(tmp_path, '<carrier capacity="2"/>')
    done = drive(program, robot=robot, elements=f'<robot x="0" y="0"/>{PLACES}', area=AREA)
    assert done.numbers == [0, 0, 1, 1, 2, 0, 1, 1]


def test_robot_without_carrier_is_refused():
    program = "return crs_take() + crs_drop() + (crs_items() != -1);"
    assert drive(program, elements=f'<robot x="0" y="0"/>{PLACES}', area=AREA).status == 0


def test_sources_and_nests_are_in_the_results_of_a_run(tmp_path, capsys):
    scout_with(tmp_path, "<carrier/>")
    program, world = tmp_path / "p.c", tmp_path / "w.xml"
    mcap = tmp_path / "run.mcap"
    program.write_text(
        '#include "crs.h"\nint main(void) { crs_take(); crs_drop(); return crs_take() - 1; }\n'
    )
    robot = '<robot definition="scout-with.xml" x="0" y="0"/>'
    world.write_text(f'<world version="1"><area {AREA}/>{PLACES}{robot}</world>')
    assert (
        main(["run", str(program), str(world), "--json", "--summary", "--record", str(mcap)]) == 0
    )
    out, err = capsys.readouterr()
    found = json.loads(out)
    assert found["sources"] == [{"id": "source0", "taken": 2, "left": 7}]
    assert found["nests"] == [{"id": "nest0", "brought": 1}]
    assert "source source0: 2 items taken, 7 left" in err
    assert "nest nest0: 1 item brought" in err
    recording = Recording(mcap)
    assert json.loads(recording.result["nests"]) == found["nests"]
    items = [each["text"] for _, each in recording.data(EVENT.topic) if each["kind"] == "item"]
    taken = "took an item from 'source0'"
    assert items == [taken, "brought an item to 'nest0'", taken]
