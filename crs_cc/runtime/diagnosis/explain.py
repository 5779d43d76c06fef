"""Explain in plain words why a program was stopped: one function for each kind of error.

The reader may be new to C. A sentence says what the program did and what is wrong
with it; the notes describe the object: its size, where it is declared, where a block of the
heap was allocated and freed.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import dataclass
from typing import Final

from crs_cc.ir.instruction import Variable
from crs_cc.ir.names import plain_name
from crs_cc.ir.program import Program
from crs_cc.ir.types import ArrayType, CType, PointerType, spell
from crs_cc.runtime.diagnosis.active_call import ActiveCall
from crs_cc.runtime.diagnosis.arguments import variable_argument
from crs_cc.runtime.diagnosis.expression_text import names_in, pointer_in
from crs_cc.runtime.diagnosis.failure import Failure
from crs_cc.runtime.diagnosis.inspect import StackFrame
from crs_cc.runtime.diagnosis.object_text import count, object_name, object_notes
from crs_cc.runtime.diagnosis.objects import Object
from crs_cc.runtime.diagnosis.origin import origin_of
from crs_cc.runtime.diagnosis.values import place_name
from crs_cc.runtime.diagnosis.variables import Variables
from crs_cc.runtime.layout import MEMORY_BYTES, NULL_SIZE, STACK_SIZE

_CALL: Final = re.compile(r"\(?\s*\*?\s*([\w.>\[\]-]+?)\s*\)?\s*\(")
LARGEST_SCALAR: Final = 8  # bytes; a larger access starts inside the object that it overruns
FORMATTED: Final = ("printf", "scanf")
FORMAT_HINT: Final = "hint: does the format match the arguments?"
CONNECT_HINT: Final = (
    "hint: --client ndirect also needs model, device, and baud rate or port:"
    ' connect_robot(1, MODEL_SCOUT, "/dev/ttyS0", 38400)'
)


@dataclass(frozen=True, slots=True)
class Case:
    """A failure with its context.

    Attributes:
        expression: the text of the expression that failed, if known.
        variables: reads the program.
        frame: the innermost frame in the user's files.
        callee: the library function that it called, if the failure is in there.
    """

    failure: Failure
    expression: str = ""
    variables: Variables | None = None
    frame: StackFrame | None = None
    callee: ActiveCall | None = None

    @property
    def access(self) -> str:
        """The access in words: `reads 4 bytes`, `strcpy writes 1 byte`."""
        failure = self.failure
        verb = {"read": "reads", "write": "writes", "": "accesses"}[failure.access]
        what = count(failure.size, "byte") if failure.size else "memory"
        return f"{self.callee.function} {verb} {what}" if self.callee else f"{verb} {what}"

    @property
    def called(self) -> str:
        """The text of the callee, if the expression is a call."""
        found = _CALL.match(self.expression)
        return found[1] if found else ""

    def find(self, name: str) -> tuple[CType, bytes] | None:
        """Return type and content of a variable."""
        if self.variables is None or self.frame is None:
            return None
        known = self.variables.find(name, self.frame)
        return None if known is None else (known.variable.ctype, known.content)

    def pointer(self) -> tuple[str, int | None] | None:
        """Return the last pointer that the expression dereferences, and its value if known."""
        if self.variables is None or self.callee is not None:
            return None
        return pointer_in(self.expression, self.find, self.variables.read)

    def pointee(self) -> Object | None:
        """Return the object that the dereferenced pointer points to, if it does.

        What the index or member of an access leaves is this object, whichever is next to it.
        """
        _, value = self.pointer() or ("", None)
        if value is None or self.variables is None:
            return None
        found = self.variables.objects.at(value)
        return found if found is not None and found.distance(value) == 0 else None

    def null_variable(self) -> str:
        """Return the variable in the expression that is a null pointer, if there is exactly one."""
        known = [(name, self.find(name)) for name in names_in(self.expression)]
        null = [
            name
            for name, found in known
            if found and isinstance(found[0], PointerType) and not any(found[1])
        ]
        return null[0] if len(null) == 1 else ""


@dataclass(frozen=True, slots=True)
class Explanation:
    """An explanation.

    Attributes:
        text: what happened; empty if the kind suffices.
        notes: further information, a sentence each.
        mentioned: the variable whose value is in the text.
        blamed: the only variable of the expression at fault, if there is one.
        shows_callee: whether to show the library function in the call stack.
        shows_values: whether to show the values of the variables in the expression.
    """

    text: str
    notes: tuple[str, ...] = ()
    mentioned: str = ""
    blamed: str = ""
    shows_callee: bool = True
    shows_values: bool = True


def explain(case: Case) -> Explanation:
    """Return the explanation of a failure."""
    words = EXPLAIN.get(case.failure.kind)
    return Explanation("") if words is None else words(case)


# Pointers


def _null(case: Case) -> Explanation:
    if case.callee is not None:
        name, address = case.callee.function, case.failure.value
        null = [each for each, shown in case.callee.arguments if shown == "null"]
        notes = (FORMAT_HINT,) if name.endswith(FORMATTED) else ()
        if null:
            return Explanation(f"{name} is passed a null pointer as '{null[0]}'")
        what = "a null pointer" if address == 0 else f"{address:#x}, which is not a valid pointer"
        return Explanation(f"{name} is passed {what}", notes)
    text, value = case.pointer() or ("", None)
    if text and (value == 0 or (value is None and case.failure.value == 0)):
        return Explanation(f"'{text}' is null", mentioned=text)
    if text and value is not None and value < NULL_SIZE:
        return Explanation(f"'{text}' is {value:#x}, which is not a valid pointer", mentioned=text)
    name = case.null_variable()
    if name:
        return Explanation(f"'{name}' is null", mentioned=name)
    return Explanation(f"{case.access} at address {case.failure.value:#x}")


def _outside(case: Case) -> Explanation:
    if case.failure.stopped is None:
        return Explanation("the access is unknown without memory checks")
    text, value = case.pointer() or ("", None)
    address = case.failure.value
    if text and value is not None and value >= MEMORY_BYTES:
        what = f"'{text}' is {value:#x}"
    elif case.expression and case.callee is None:
        what = f"'{case.expression}' is at {address:#x}"
    else:
        what = f"{case.access} at {address:#x}"
    return Explanation(f"{what}, outside the program's memory", mentioned=text)


def _wild(case: Case) -> Explanation:
    failure = case.failure
    text = f"{case.access} at {failure.value:#x}, where there is no object"
    return Explanation(text, object_notes(failure.object, failure.value))


def _out_of_bounds(case: Case) -> Explanation:
    failure, found = case.failure, case.pointee() or case.failure.object
    if failure.array is not None:
        return _index(failure, *failure.array)
    if found is None:
        return _wild(case)
    behind = failure.value - (found.address + found.size)
    before = found.address - failure.value
    if behind == 0 and failure.size > LARGEST_SCALAR:
        where = "across the end of"
    elif behind >= 0:
        where = f"starting {count(behind, 'byte')} past" if behind else "right after"
        where += " the end of"
    else:
        is_far = before > failure.size
        where = f"starting {count(before, 'byte')} before" if is_far else "right before"
        where += " the start of"
    text = f"{case.access} {where} {object_name(found)}"
    return Explanation(text, object_notes(found, failure.value))


def _index(failure: Failure, array: ArrayType, address: int) -> Explanation:
    """Explain an index that is out of an array's bounds."""
    found, index = failure.object, failure.value - (failure.value >> 31 << 32)
    where = "before the start" if index < 0 else "past the end"
    whole = found is not None and found.distance(address) == 0
    if found is None or not whole or found.variable is None:
        inside = f" in {object_name(found)}" if found is not None and whole else ""
        text = f"index {index} is {where} of an array of {count(array.length or 0, 'element')}"
        return Explanation(text + inside, object_notes(found) if whole else ())
    part = place_name(found.name, found.variable.ctype, address - found.address, array)
    notes = object_notes(found)
    if part != found.name:
        notes = (f"'{part}' is {spell(array)}, {count(array.size, 'byte')}", *notes)
    return Explanation(f"index {index} is {where} of '{part}'", notes)


def _constant(case: Case) -> Explanation:
    found = case.failure.object
    is_const = found is not None and found.variable is not None
    text = f"{case.access} to {object_name(found)}" + (", which is const" if is_const else "")
    return Explanation(text, object_notes(found))


def _freed(case: Case) -> Explanation:
    failure, found = case.failure, case.failure.object
    offset = failure.value - found.address if found else 0
    text = f"{case.access} at offset {offset} in {object_name(found, 'a freed')}"
    return Explanation(text, object_notes(found, failure.value))


def _scope(case: Case) -> Explanation:
    failure = case.failure
    text = f"{case.access} of {object_name(failure.object)}, whose scope has ended"
    return Explanation(text, object_notes(failure.object, failure.value))


def _returned(case: Case) -> Explanation:
    failure, found = case.failure, case.failure.object
    if found is None:
        return Explanation(f"{case.access} of a local variable of a function that has returned")
    local = f"a local variable of '{plain_name(found.function)}', which has returned"
    notes = object_notes(found, failure.value)
    return Explanation(f"{case.access} of {object_name(found)}, {local}", notes)


def _origin(case: Case) -> tuple[str, ...]:
    """Say where bytes without value were copied from, if they were."""
    failure, found = case.failure, case.failure.object
    if failure.stopped is None or not failure.value:
        return ()
    origin = origin_of(failure.stopped, failure.value, failure.size)
    if isinstance(origin, Variable):
        is_copy = found is None or found.variable != origin
        note = f"it is a copy from '{origin.name}', declared at {origin.location}"
        return (note,) if is_copy else ()
    if origin is None or (found is not None and origin in found.allocated):
        return ()
    owner = plain_name(origin.function)
    return (f"it is a copy from a heap block, allocated at {origin.location} in {owner}",)


def _uninitialised(case: Case) -> Explanation:
    failure, found = case.failure, case.failure.object
    notes = (*object_notes(found), *_origin(case))
    if found is not None and found.variable is not None:
        offset = max(0, failure.value - found.address) if failure.value else 0
        part = place_name(found.name, found.variable.ctype, offset)
        if case.callee is None:
            blamed = found.name if part == found.name else ""
            return Explanation(f"'{part}' has no value yet", notes, found.name, blamed)
        return Explanation(f"{case.access} of '{part}', which has no value yet", notes)
    if found is not None and found.kind == "heap block":
        where = f"at offset {failure.value - found.address} in {object_name(found)}"
        if case.callee is None and case.expression:
            return Explanation(f"'{case.expression}' has no value yet", (f"it is {where}", *notes))
        return Explanation(f"{case.access} {where}, which has no value yet", notes)
    if not case.expression:
        return Explanation("the value used here is uninitialised", notes)
    return Explanation(f"'{case.expression}' has no value yet", notes)


# The heap


def _invalid_free(case: Case) -> Explanation:
    failure, found = case.failure, case.failure.object
    callee = case.callee.function if case.callee else "free"
    if found is None or found.distance(failure.value):
        return Explanation(f"{callee} is passed {failure.value:#x}, which malloc never returned")
    offset = failure.value - found.address
    if found.kind == "heap block":
        text = f"{callee} is passed a pointer to offset {offset} in {object_name(found)}"
        return Explanation(f"{text}, not to its start", object_notes(found))
    text = f"{callee} is passed a pointer to {object_name(found)}, which malloc never returned"
    return Explanation(text, object_notes(found, failure.value if offset else None, "it points"))


def _overlap(case: Case) -> Explanation:
    callee = case.callee.function if case.callee else "a copy"
    text = f"the source and destination of {callee} overlap in {object_name(case.failure.object)}"
    return Explanation(text, object_notes(case.failure.object))


def _unrelated(case: Case) -> Explanation:
    first, second = case.failure.object, case.failure.other
    one, two = object_name(first), object_name(second)
    if one == two:
        two = "another"
    text = f"one points to {one}, the other to {two}"
    hint = "hint: to subtract addresses of different objects, convert them to 'uintptr_t'"
    return Explanation(text, (*object_notes(first), *object_notes(second), hint))


def _double_free(case: Case) -> Explanation:
    failure = case.failure
    text = f"{object_name(failure.object, 'the')} has already been freed"
    return Explanation(text, object_notes(failure.object, failure.value))


# Functions


def _missing_argument(case: Case) -> Explanation:
    if case.callee is not None:
        name = case.callee.function
        text = f"{name} needs more arguments than were passed"
        if name == "connect_robot":
            return Explanation(text, (CONNECT_HINT,))
        return Explanation(text, (FORMAT_HINT,) if name.endswith(FORMATTED) else ())
    return Explanation("va_arg reads an argument that was not passed", shows_values=False)


def _mismatched_argument(case: Case) -> Explanation:
    failure = case.failure
    wanted = spell(failure.ctype) if failure.ctype is not None else "a different type"
    number, passed = 0, "of a different type"
    if failure.stopped is not None:
        found = variable_argument(failure.stopped, failure.value)
        number, passed = (found[0], spell(found[1])) if found else (number, passed)
    if case.callee is not None:
        name = case.callee.function
        text = f"{name} reads argument {number} as {wanted}, but it is {passed}"
        return Explanation(text, (FORMAT_HINT,) if name.endswith(FORMATTED) else ())
    owner = plain_name(failure.object.function) if failure.object else "the function"
    text = f"argument {number} of '{owner}' is {passed}, but va_arg reads {wanted}"
    return Explanation(text, shows_values=False)


def _no_value(case: Case) -> Explanation:
    name = f"'{case.called}'" if case.called else "the function called"
    program = case.failure.stopped.program if case.failure.stopped else Program()
    notes = [
        f"'{case.called}' is defined at {each.location}: every path through it needs a 'return'"
        for each in program.functions.values()
        if plain_name(each.name) == case.called
    ]
    text = f"{name} ended without 'return', but its value is used"
    return Explanation(text, tuple(notes[:1]), shows_values=False)


def _mismatched(case: Case) -> Explanation:
    stopped, pointer = case.failure.stopped, case.failure.value
    for each in stopped.program.functions.values() if stopped else ():
        if stopped and stopped.compiled.addresses.get(each.name) == pointer and each.ctype:
            name = plain_name(each.name)
            subject = f"'{case.called}' points to '{name}', which" if case.called else f"'{name}'"
            note = f"'{name}' is {spell(each.ctype, name)}, defined at {each.location}"
            return Explanation(f"{subject} has a different type", (note,), shows_values=False)
    return Explanation("the pointer's type is not that of the function called")


def _bad_function(case: Case) -> Explanation:
    value = case.failure.value
    name = f"'{case.called}'" if case.called else "the pointer called"
    what = "is null" if value == 0 else f"is {value:#x}, which is not a function"
    return Explanation(f"{name} {what}", mentioned=case.called)


def _stack(case: Case) -> Explanation:
    stopped = case.failure.stopped
    if stopped is None or not stopped.stack:
        # Our own check fails before the host's stack overflows, unless that is a small one.
        return Explanation("the system's stack limit was reached (see 'ulimit -s')")
    innermost = stopped.stack[0].function
    if innermost == "__crs_take_thunk":
        text = "too many active calls hold pointers to the same nested function"
        hint = "hint: pass the pointer on, instead of taking it in each call"
        return Explanation(text, (hint,), shows_values=False)
    size = stopped.compiled.info(innermost).frame.size
    if size * 4 > STACK_SIZE:
        name = plain_name(innermost)
        text = f"the variables of '{name}' take {size:,} bytes of a stack of {STACK_SIZE:,}"
        return Explanation(text, ("hint: make large arrays static",), shows_values=False)
    text = f"{len(stopped.stack):,} nested calls fill the {STACK_SIZE:,}-byte stack"
    return Explanation(text, ("hint: does the recursion end?",), shows_values=False)


def _assertion(case: Case) -> Explanation:
    variables = case.variables
    for frame in case.failure.stack if variables else ():
        if frame.function == "__crs_assert_failed" and variables:
            address = int.from_bytes(variables.arguments(frame)[0].content, "little")
            text = variables.read(address, 200).partition(b"\0")[0].decode("utf-8", "replace")
            return Explanation(text, shows_callee=False)
    return Explanation("", shows_callee=False)


# Arithmetic


def _shift(case: Case) -> Explanation:
    value = case.failure.value
    value -= (value >> 31) << 32
    return Explanation(f"the shift count is {value:,}")


def _constant_text(text: str, *, shows_callee: bool = True) -> Callable[[Case], Explanation]:
    return lambda _case: Explanation(text, shows_callee=shows_callee)


EXPLAIN: Final[dict[str, Callable[[Case], Explanation]]] = {
    "null pointer": _null,
    "pointer outside memory": _outside,
    "wild pointer": _wild,
    "out of bounds": _out_of_bounds,
    "write to read-only memory": _constant,
    "use after free": _freed,
    "use after scope": _scope,
    "use after return": _returned,
    "uninitialised read": _uninitialised,
    "invalid free": _invalid_free,
    "double free": _double_free,
    "overlapping copy": _overlap,
    "unrelated pointers": _unrelated,
    "missing argument": _missing_argument,
    "mismatched argument": _mismatched_argument,
    "no value returned": _no_value,
    "mismatched call": _mismatched,
    "shift out of range": _shift,
    "signed overflow": _constant_text("the result does not fit in its type"),
    "division overflow": _constant_text("the quotient does not fit in its type"),
    "bad function pointer": _bad_function,
    "stack overflow": _stack,
    "corrupted stack": _constant_text("the program has overwritten its call stack"),
    "abort called": _constant_text("", shows_callee=False),
    "unhandled signal": _constant_text("", shows_callee=False),
    "assertion failed": _assertion,
    "internal trap": _constant_text("a bug in crs, please report it"),
}
"""The function that explains each kind of error."""
