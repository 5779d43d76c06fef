"""The linker: join the programs of several C files, and the library units that they need.

The user's files are linked like object files: two definitions of a name are an error, and
tentative definitions (`int count;` in several files, or in a header) are merged, as with
gcc's `-fcommon`. The library is linked like an archive: only what is needed and not defined by
the user.
"""

from __future__ import annotations

import difflib
from collections.abc import Sequence
from dataclasses import replace
from typing import Final, Protocol

from crs_cc.core.errors import CompileError
from crs_cc.core.source import Diagnostics, Location
from crs_cc.ir.instruction import Call
from crs_cc.ir.names import LIBRARY, in_library
from crs_cc.ir.program import Data, Function, Program, Relocation
from crs_cc.ir.type_compat import are_compatible
from crs_cc.ir.types import CType
from crs_cc.ir.uses import uses
from crs_cc.ir.value_type import MemoryType
from crs_cc.runtime.aliases import resolve_aliases
from crs_cc.runtime.missing import set_addresses_to_zero

ROOT: Final = "__crs_start"
"""The library's function that calls `main`; everything reachable from it is linked."""

ALLOCATOR: Final = LIBRARY + "stdlib/malloc.c"
"""The library's file whose functions access memory that C may not."""

STARTS: Final = "__crs_starts"
"""The null-terminated array of functions to be called before `main`."""

ENDS: Final = "__crs_ends"
"""The null-terminated array of functions to be called at exit."""

START_OF: Final = "__crs_start_"
"""With the name of a variable of the library: a function to be called before `main` by programs
that use it."""

HEAP_SYMBOLS: Final = ("__heap_start", "__heap_end")
"""Names that the code generator defines: the ends of the memory left for `malloc`."""

CONNECTS: Final = "connect_robot"
"""The function with which every program connects to its robot."""

_SIMILAR: Final = 0.7  # three of four letters


class Library(Protocol):
    """Where undefined names of the user's files are looked up."""

    def find(self, name: str) -> Function | Data | None:
        """Return the library's definition of a name."""

    def names(self) -> Sequence[str]:
        """Return all public names of the library."""


def link(units: Sequence[Program], library: Library, diagnostics: Diagnostics) -> Program:
    """Link a program; raise CompileError if a name is defined twice, or undefined."""
    diagnostics.stage = "linking"
    user = join(units, diagnostics)
    resolve_aliases(user)
    whole = Program()
    for table, calls in ((STARTS, _in_order(user.starts)), (ENDS, _in_order(user.ends)[::-1])):
        user.data[table] = _table(table, calls)
    work, starts, missing = [ROOT], list[str](), set[str]()
    for name in work:
        if name in whole.functions or name in whole.data or name in HEAP_SYMBOLS:
            continue
        found = _find(name, user, library)
        if isinstance(found, Function):
            whole.functions[name] = found
        elif isinstance(found, Data):
            whole.data[name] = found
            if in_library(found.location) and library.find(START_OF + name) is not None:
                starts.append(START_OF + name)
                work.append(START_OF + name)
        else:
            _undefined(name, user, library, diagnostics)
            missing.add(name)
            continue
        work.extend(references(found))
    whole.unused = Program(
        {name: each for name, each in user.functions.items() if name not in whole.functions},
        {name: each for name, each in user.data.items() if name not in whole.data},
    )
    if starts:
        whole.data[STARTS] = _table(STARTS, [*starts, *_in_order(user.starts)])
    if not diagnostics.errors:
        set_addresses_to_zero(whole, missing)
        _check_client(whole, diagnostics)
        _check_uses(whole, diagnostics)
        _check_arguments(whole, diagnostics)
    if diagnostics.errors:
        raise CompileError(diagnostics.errors)
    return whole


def _check_client(whole: Program, diagnostics: Diagnostics) -> None:
    """Warn of a program that defines the vendor's client, and so reaches no simulated robot."""
    connects = whole.functions.get(CONNECTS)
    if connects is not None and not in_library(connects.location):
        text = f"'{CONNECTS}' is redefined: the program cannot reach its simulated robot"
        hint = "omit the vendor's Ndirect.c or Nclient.c: crs provides their functions"
        diagnostics.warning(connects.location, text, hint, flag="client-redefined")


def _check_uses(whole: Program, diagnostics: Diagnostics) -> None:
    """Report variables that are called, and functions that are read or written as variables."""
    reported = set()
    for function in whole.functions.values():
        for (name, use), location in uses(function).items():
            if use == "call" and name in whole.data:
                text = f"'{name}' is called as a function, but it is a variable"
                defined = whole.data[name].location
            elif use == "access" and name in whole.functions:
                text = f"'{name}' is used as a variable, but it is a function"
                defined = whole.functions[name].location
            else:
                continue
            if name not in reported:
                reported.add(name)
                # The library calls main: report a mismatch at the definition.
                place = defined if in_library(location) else location
                diagnostics.error(place, text, f"defined at {defined}")


def _check_arguments(whole: Program, diagnostics: Diagnostics) -> None:
    """Warn of arguments that no prototype converted to the parameter's type."""
    for function in whole.functions.values():
        if in_library(function.location):
            continue
        for block in function.blocks:
            call = block.terminator
            if isinstance(call, Call) and isinstance(call.callee, str):
                callee = whole.functions.get(call.callee)
                if callee is not None:
                    _compare_arguments(call, callee, diagnostics)


def _compare_arguments(call: Call, callee: Function, diagnostics: Diagnostics) -> None:
    pairs = zip(call.arguments, callee.parameters, strict=False)
    for number, (argument, parameter) in enumerate(pairs, start=1):
        passed, taken = _passed_as(argument.memory), _passed_as(parameter.memory)
        if passed != taken:
            text = f"argument {number} is passed as {passed}, but '{callee.name}' takes {taken}"
            hint = "without a prototype it is not converted; " + _where_defined(callee)
            diagnostics.warning(call.location, text, hint, flag="argument-mismatch")
            return


def _passed_as(memory: MemoryType | None) -> str:
    """Return the type that a value is passed as; everything takes 4 bytes or more."""
    match memory:
        case None:
            return "a struct"
        case "f64":
            return "a double"
        case "f32":
            return "a float"
        case "i64":
            return "a long long"
        case _:
            return "an integer"


def _where_defined(callee: Function) -> str:
    if in_library(callee.location):
        return "include the header that declares it"
    return f"defined at {callee.location}"


def join(units: Sequence[Program], diagnostics: Diagnostics) -> Program:
    """Return one program with the definitions of all units; report multiple definitions."""
    whole = Program()
    for unit in units:
        _add_functions(unit, whole, diagnostics)
        _add_data(unit, whole, diagnostics)
        for name, location in unit.undefined.items():
            whole.undefined.setdefault(name, location)
        whole.optional |= unit.optional
        for name, meant in unit.aliases.items():
            whole.aliases.setdefault(name, meant)
        whole.starts += unit.starts
        whole.ends += unit.ends
    for name in [each for each in whole.aliases if each in whole.functions or each in whole.data]:
        del whole.aliases[name]  # a weak alias, which a definition overrides
    for unit in units:
        whole.optional -= unit.undefined.keys() - unit.optional
        for name, (ctype, location) in unit.declared.items():
            whole.declared.setdefault(name, (ctype, location))
            _compare(name, ctype, location, whole, diagnostics)
    return whole


def _add_functions(unit: Program, whole: Program, diagnostics: Diagnostics) -> None:
    for name, function in unit.functions.items():
        if _is_overridden(name, unit, whole):
            continue
        if name in whole.functions or name in whole.data:
            _defined_twice(name, function.location, whole, diagnostics)
        else:
            whole.functions[name] = function


def _add_data(unit: Program, whole: Program, diagnostics: Diagnostics) -> None:
    for name, data in unit.data.items():
        if _is_overridden(name, unit, whole):
            continue
        if name in whole.functions:
            _defined_twice(name, data.location, whole, diagnostics)
        elif name in whole.data:
            whole.data[name] = _merge(whole.data[name], data, whole, diagnostics)
        else:
            whole.data[name] = data


def _compare(
    name: str, ctype: CType, location: Location, whole: Program, diagnostics: Diagnostics
) -> None:
    """Warn of a declaration whose type differs from the definition in another file."""
    function, data = whole.functions.get(name), whole.data.get(name)
    defined, place = None, location
    if function is not None:
        defined, place = function.ctype, function.location
    elif data is not None and data.variable is not None:
        defined, place = data.variable.ctype, data.location
    if defined is not None and not are_compatible(ctype, defined):
        text = f"'{name}' is '{ctype}' here, but '{defined}' where it is defined"
        diagnostics.warning(location, text, f"defined at {place}", flag="lto-type-mismatch")


def _is_overridden(name: str, unit: Program, whole: Program) -> bool:
    """Return whether a weak definition is overridden; remove an earlier weak one."""
    if name not in whole.functions and name not in whole.data:
        if name in unit.weak:
            whole.weak.add(name)
        return False
    if name in unit.weak:
        return True
    if name in whole.weak:
        whole.weak.remove(name)
        whole.functions.pop(name, None)
        whole.data.pop(name, None)
    return False


def _in_order(calls: list[tuple[int, str]]) -> list[str]:
    return [name for _, name in sorted(calls, key=lambda call: call[0])]


def _table(name: str, functions: list[str]) -> Data:
    """Return a null-terminated array of function pointers."""
    size = 4 * len(functions) + 4
    relocations = [Relocation(4 * i, function, 0) for i, function in enumerate(functions)]
    place = Location(LIBRARY)
    return Data(name, size, 4, place, bytes(size) if functions else None, relocations)


def references(definition: Function | Data) -> list[str]:
    """Return the names that a definition uses, in order."""
    if isinstance(definition, Data):
        return [relocation.symbol for relocation in definition.relocations]
    return [name for name, _ in uses(definition)]


def address_taken_functions(program: Program) -> list[str]:
    """Return the functions whose address is taken, in a fixed order."""
    found: dict[str, None] = {}
    for function in program.functions.values():
        for name, use in uses(function):
            if use == "address" and name in program.functions:
                found[name] = None
    for data in program.data.values():
        for relocation in data.relocations:
            if relocation.symbol in program.functions:
                found[relocation.symbol] = None
    return list(found)


def _find(name: str, user: Program, library: Library) -> Function | Data | None:
    """Return the definition of a name; a tentative one of the user's is merged."""
    mine = user.functions.get(name) or user.data.get(name)
    if mine is not None and not (isinstance(mine, Data) and mine.tentative):
        return mine
    theirs = library.find(name)
    if isinstance(mine, Data) and isinstance(theirs, Data):
        return _merge_tentative(mine, theirs)
    return mine or theirs


def _merge_tentative(first: Data, second: Data) -> Data:
    """Merge two objects of one name, at least one of which is tentative (gcc -fcommon)."""
    chosen = first if second.tentative else second
    other = second if chosen is first else first
    size, align = max(chosen.size, other.size), max(chosen.align, other.align)
    content = chosen.content and chosen.content.ljust(size, b"\0")
    return replace(chosen, size=size, align=align, content=content)


def _merge(first: Data, second: Data, whole: Program, diagnostics: Diagnostics) -> Data:
    if not first.tentative and not second.tentative:
        _defined_twice(first.name, second.location, whole, diagnostics)
        return first
    if second.variable is not None:
        _compare(first.name, second.variable.ctype, second.location, whole, diagnostics)
    return _merge_tentative(first, second)


def _defined_twice(name: str, location: Location, whole: Program, diagnostics: Diagnostics) -> None:
    function = whole.functions.get(name)
    first = function.location if function else whole.data[name].location
    diagnostics.error(location, f"multiple definition of '{name}'", f"also defined at {first}")


def _undefined(name: str, user: Program, library: Library, diagnostics: Diagnostics) -> None:
    """Report a name that nothing defines, unless it is declared weak."""
    if name in user.optional:
        return
    location = user.undefined.get(name) or Location("<program>")
    if name == "runcode" and name not in user.undefined:  # the library's main calls it
        _no_main(user, diagnostics)
        return
    hint = _where_declared(name, location, user)
    if not hint:
        known = [each for each in user.functions if ":" not in each] + list(library.names())
        close = difflib.get_close_matches(name, known, 1)
        hint = f"did you mean '{close[0]}'?" if close else ""
    here = [each for each in diagnostics.messages if each.location == location]
    for each in here:
        if each.severity == "warning" and f"'{name}'" in each.text:
            diagnostics.messages.remove(each)  # the implicit declaration: this error is more useful
    diagnostics.error(location, f"'{name}' is used, but not defined", hint)


def _no_main(user: Program, diagnostics: Diagnostics) -> None:
    text = "the program has no function 'main'"
    own = {name.lower(): name for name in user.functions if ":" not in name}
    close = difflib.get_close_matches("main", own, 1, _SIMILAR)
    if close:
        found = user.functions[own[close[0]]]
        diagnostics.error(found.location, text, f"should '{found.name}' be 'main'?")
        return
    diagnostics.error(_first_place(user, diagnostics), text, "a program starts there")


def _where_declared(name: str, used: Location, user: Program) -> str:
    """Return a hint to the declaration of a name in a header, if any."""
    declared = user.declared.get(name)
    if declared is None or declared[1].file == used.file:
        return ""
    place = declared[1]
    return f"declared at {place.file}:{place.line}; is its C file missing from the command line?"


def _first_place(user: Program, diagnostics: Diagnostics) -> Location:
    """Return the start of the user's first file, which may be empty."""
    places = [function.location for function in user.functions.values()]
    places += [data.location for data in user.data.values()]
    files = [place.file for place in places if not in_library(place)]
    return Location(next(iter([*files, *diagnostics.lines]), "<program>"))
