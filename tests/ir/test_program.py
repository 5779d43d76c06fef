"""Programs as data."""

import itertools
import pickle
import sys

from crs_cc.core.source import Location
from crs_cc.ir.instruction import Block, Jump, Return
from crs_cc.ir.program import Function, Program
from crs_cc.ir.text import to_text

HERE = Location("long.c", 1, 1)


def test_a_program_with_a_long_chain_of_blocks_survives_pickling() -> None:
    blocks = [Block(f"b{number}") for number in range(20 * sys.getrecursionlimit())]
    for block, following in itertools.pairwise(blocks):
        block.terminator = Jump(HERE, following)
    blocks[-1].terminator = Return(HERE, None)
    program = Program({"long": Function("long", HERE, blocks=blocks)})
    again = pickle.loads(pickle.dumps(program))
    assert to_text(again) == to_text(program)
