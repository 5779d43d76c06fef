"""Lower statements to blocks in the order of the source."""

from __future__ import annotations

from typing import Final

from crs_cc.core.source import Location
from crs_cc.frontend.check import tree
from crs_cc.frontend.check.fold import wrap
from crs_cc.frontend.lower.lowerer import (
    Lowering,
    Rules,
    branch,
    effect,
    no_value,
    place,
    statements,
    value,
)
from crs_cc.frontend.lower.memory import copy
from crs_cc.ir.instruction import Block, Branch, Constant, Jump, Operand, Return, Stop, Switch
from crs_cc.ir.types import RecordType

_MAX_CASES = 256
"""A case range with so many values becomes a comparison instead of single cases."""


def _expression(low: Lowering, statement: tree.ExpressionStatement) -> None:
    low.mark(statement.location)
    effect(low, statement.expression)


def _if(low: Lowering, statement: tree.If) -> None:
    location = statement.location
    low.mark(location)
    then, end = low.new_block("then"), low.new_block("endif")
    otherwise = low.new_block("else") if statement.otherwise else end
    branch(low, statement.condition, then, otherwise)
    low.start(then, location)
    statements(low, statement.then)
    if statement.otherwise:
        low.end(Jump(location, end))
        low.start(otherwise, location)
        statements(low, statement.otherwise)
    low.start(end, location)


def _loop(low: Lowering, statement: tree.Loop) -> None:
    statements(low, statement.start)
    test, body = low.new_block("test"), low.new_block("body")
    step, end = low.new_block("step"), low.new_block("endloop")
    location = statement.location
    if statement.tests_first:
        low.start(test, location)
        _test(low, statement, body, end)
    low.start(body, location)
    low.breaks.append((end, len(low.scopes)))
    low.continues.append((step, len(low.scopes)))
    statements(low, statement.body)
    low.breaks.pop()
    low.continues.pop()
    low.start(step, location)
    if statement.step is not None:
        low.mark(statement.step.location)
        effect(low, statement.step)
    if statement.tests_first:
        low.end(Jump(location, test))
    else:
        _test(low, statement, body, end)
    low.start(end, location)


def _test(low: Lowering, statement: tree.Loop, body: Block, end: Block) -> None:
    if statement.condition is None:
        low.end(Jump(statement.location, body))
        return
    low.mark(statement.condition.location)
    branch(low, statement.condition, body, end)


def _switch(low: Lowering, statement: tree.Switch) -> None:
    location = statement.location
    low.mark(location)
    operand = value(low, statement.value)
    end = default = low.new_block("endswitch")
    cases: list[tuple[int, Block]] = []
    bits = 64 if operand.type == "i64" else 32
    for label in statement.labels:
        block = low.new_block("default" if label.first is None else "case")
        low.cases[label] = block
        if label.first is None or label.last is None:
            default = block
        elif label.last - label.first < _MAX_CASES:
            values = range(label.first, label.last + 1)
            cases += [(wrap(each, bits, signed=True), block) for each in values]
        else:
            _test_range(low, operand, (label.first, label.last), block, location)
    low.end(Switch(location, operand, cases, default))
    low.breaks.append((end, len(low.scopes)))
    statements(low, statement.body)
    low.breaks.pop()
    low.start(end, location)


def _test_range(
    low: Lowering, operand: Operand, ends: tuple[int, int], block: Block, location: Location
) -> None:
    """Branch to `block` if a value is in a case range that is too long for single cases."""
    (first, last), kind = ends, operand.type
    bits = 64 if kind == "i64" else 32
    start = Constant(kind, wrap(first, bits, signed=True))
    length = Constant(kind, wrap(last - first, bits, signed=True))
    above = low.binary(location, f"{kind}.sub", operand, start)
    inside = low.binary(location, f"{kind}.le_u", above, length)
    other = low.new_block("next")
    low.end(Branch(location, inside, block, other))
    low.start(other, location)


def _case(low: Lowering, statement: tree.CaseLabel) -> None:
    low.start(low.cases[statement], statement.location)


def _label_block(low: Lowering, name: str) -> Block:
    if name not in low.labels:
        low.labels[name] = low.new_block(name)
    return low.labels[name]


def _label(low: Lowering, statement: tree.Label) -> None:
    low.start(_label_block(low, statement.name), statement.location)


def _goto(low: Lowering, statement: tree.Goto) -> None:
    low.mark(statement.location)
    if statement.nonlocal_goto is not None:
        effect(low, statement.nonlocal_goto)
        return
    _release(low, statement.release)
    low.leave_scopes(0, statement.location)
    low.end(Jump(statement.location, _label_block(low, statement.name)))


def _computed_goto(low: Lowering, statement: tree.ComputedGoto) -> None:
    """Jump to the label with a number through one switch for the whole function."""
    location = statement.location
    low.mark(location)
    operand = value(low, statement.target)
    if low.chooser is None:
        number, block, wrong = (
            low.new_register("i32"),
            low.new_block("goto"),
            low.new_block("wrong"),
        )
        low.chooser = number, block
        cases = [(n, _label_block(low, name)) for name, (n, _) in statement.numbers.items()]
        block.terminator = Switch(location, number, cases, wrong)
        wrong.terminator = Stop(location, "invalid goto target")
        low.function.blocks += [block, wrong]
    number, block = low.chooser
    low.move(number, operand, location)
    low.leave_scopes(0, location)
    low.end(Jump(location, block))


def _break(low: Lowering, statement: tree.Break) -> None:
    _leave(low, statement.location, *low.breaks[-1])


def _continue(low: Lowering, statement: tree.Continue) -> None:
    _leave(low, statement.location, *low.continues[-1])


def _leave(low: Lowering, location: Location, target: Block, scopes: int) -> None:
    """Jump to the end of a loop or switch, or to its next iteration."""
    low.mark(location)
    low.leave_scopes(scopes, location)
    low.end(Jump(location, target))


def _return(low: Lowering, statement: tree.Return) -> None:
    location, result = statement.location, statement.value
    low.mark(location)
    if result is None:
        _release(low, statement.release)
        low.end(Return(location, no_value(low.function)))
    elif isinstance(result.type, RecordType):
        assert low.result_pointer is not None
        copy(low, (low.result_pointer, 0), place(low, result), result.type.size, location)
        _release(low, statement.release)
        low.end(Return(location, None))
    else:
        operand = value(low, result)
        _release(low, statement.release)
        low.end(Return(location, operand))


def _release(low: Lowering, release: tree.Expression | None) -> None:
    if release is not None:
        effect(low, release)


RULES: Final = Rules(
    statement={
        tree.ExpressionStatement: _expression,
        tree.If: _if,
        tree.Loop: _loop,
        tree.Switch: _switch,
        tree.CaseLabel: _case,
        tree.Label: _label,
        tree.Goto: _goto,
        tree.ComputedGoto: _computed_goto,
        tree.Break: _break,
        tree.Continue: _continue,
        tree.Return: _return,
    },
)
