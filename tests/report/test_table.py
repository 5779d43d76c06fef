"""The table of the report's commands agrees with its header and the library."""

from __future__ import annotations

import re

import pytest

from crs_cc.core.source import Diagnostics
from crs_cc.frontend.preprocess.options import Options
from crs_cc.frontend.unit import compile_text
from crs_cc.robot_api.report import COMMANDS, REPORT_STATE, Command
from crs_cc.session.library import HEADERS, library

HEADER = (HEADERS / "crs" / "report.h").read_text()
DECLARED = re.findall(r'^(int \w+\([^;]*?\))\s+__asm__\("(\w+)"\);', HEADER, re.MULTILINE)

VM_OF_WHEELS = "__report_vm_of_wheels"
"""What `vm` with three arguments calls."""

TABLE_1 = """
connect_robot disconnect_robot conf_tm real_robot simulated_robot pr vm mv st ws dp ac sp conf_sn
get_sn get_bp
"""
SECTION_2_2 = (
    "connect_robot disconnect_robot vm st ws ac pr scout_vm scout_pr conf_sn get_sn get_bp"
)
SECTION_3_3 = """
connect_robot disconnect_robot scout_pr pr dp vm st ws conf_sn get_bp heatSensorCheck
sonarSensorCheck
"""
APPENDIX_A = """
connect_robot disconnect_robot dp get_bp heatSensorCheck pr scout_pr sonarSensorCheck tagTarget ws
"""


def test_the_table_lists_exactly_the_headers_declarations_in_order() -> None:
    assert sorted(each.prototype for each in COMMANDS) == sorted(
        " ".join(prototype.split()) for prototype, label in DECLARED if label != VM_OF_WHEELS
    )


@pytest.mark.parametrize("listed", [TABLE_1, SECTION_2_2, SECTION_3_3, APPENDIX_A])
def test_every_command_of_the_reports_lists_is_there(listed: str) -> None:
    assert {each.name for each in COMMANDS} >= set(listed.split())


@pytest.mark.parametrize("command", COMMANDS, ids=lambda command: command.name)
def test_every_command_is_in_the_library(command: Command) -> None:
    name = {prototype.split("(")[0].split()[-1]: label for prototype, label in DECLARED}
    assert library().find(name[command.name]) is not None
    assert command.meaning
    assert command.source


def test_the_indices_are_those_of_the_header_and_else_of_the_vendors() -> None:
    defined = dict(re.findall(r"#define (NUM_STATE|STATE_\w+) +(\d+)", HEADER))
    vendors = (HEADERS / "Nclient.h").read_text()
    theirs = dict(re.findall(r"#define (NUM_STATE|STATE_\w+) +(\d+)", vendors))
    assert {name for name, _, _ in REPORT_STATE} <= set(defined)
    assert {name for name, value in defined.items() if theirs.get(name) != value} == {
        "NUM_STATE", "STATE_HEAT",
    }  # fmt: skip


def test_the_header_needs_nothing_of_the_program() -> None:
    messages = Diagnostics()
    options = Options(system_paths=(HEADERS,), dialect="report")
    compile_text("int runcode(void) { return NULL == 0; }", "a.c", options, messages)
    assert not messages.messages
