"""The names of all warnings, and the selection of warnings by the user.

A warning has the name of gcc's or clang's, where these have it; `-W` options select by name:

>>> selection = Selection.of(["no-unused", "error=format"])
>>> selection.severity("unused-value"), selection.severity("format")
(None, 'error')
>>> selection.severity("uninitialized")
'warning'
"""

from __future__ import annotations

import difflib
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field, replace
from typing import Final, Literal

from crs_cc.core.source import Diagnostic

WARNINGS: Final = {
    # Preprocessing and parsing
    "attributes": "an unknown attribute is ignored",
    "builtin-macro-redefined": "#undef of a predefined macro such as __LINE__",
    "cpp": "a #warning directive",
    "empty-body": "a semicolon directly after if, for or while",
    "extra-tokens": "text after a directive is ignored",
    "header-name": "a missing header is replaced by a similar one",
    "implicit-int": "a declaration without a type",
    "macro-redefined": "a macro is redefined differently",
    "missing-space": "no space between a macro's name and its body",
    "parentheses": "operators of confusing precedence; an assignment as a condition",
    "pragmas": "a malformed #pragma",
    "reversed-assignment": "x =- 1 instead of x -= 1",
    "stray-token": "a token that is not allowed in a macro's body",
    "unknown-escape-sequence": "an unknown escape sequence in a string",
    "unknown-pragmas": "an unknown #pragma",
    # Types and declarations
    "argument-mismatch": "a call without a prototype passes arguments of the wrong types",
    "client-redefined": "the program defines a function of the Nomadic client",
    "conflicting-types": "a declaration differs from an earlier one, or from an earlier call",
    "discarded-qualifiers": "a pointer conversion drops const or volatile",
    "distinct-pointer-types": "a comparison of pointers to different types",
    "excess-initializers": "more initializers than elements",
    "extern-initializer": "an extern declaration with an initializer",
    "implicit-function-declaration": "a function is called without a declaration",
    "incompatible-pointer-types": "a conversion between pointers to different types",
    "int-conversion": "a conversion between integers and pointers without a cast",
    "library-redeclaration": "a library function is declared with a different type",
    "lto-type-mismatch": "a declaration differs from the definition in another file",
    "missing-declarations": "a declaration that declares nothing",
    "pointer-integer-compare": "a comparison between a pointer and an integer",
    "pointer-to-int-cast": "a pointer is cast to an integer that is too small",
    "pointer-type-mismatch": "the two results of ?: have different pointer types",
    "static-follows-non-static": "a function is declared static after it was called",
    "tentative-array": "an array of unknown length",
    "varargs": "va_arg with a type that is never passed",
    # Values and control flow
    "array-bounds": "a constant index outside its array",
    "div-by-zero": "a division by the constant zero",
    "empty-case-range": "a case range without values",
    "format": "arguments of printf or scanf that do not match the format",
    "integer-division": "an integer division whose result is used as a floating-point number",
    "overflow": "a constant that does not fit in its type",
    "return-local-addr": "the address of a local variable is returned",
    "sequence-point": "a variable is modified and used in an unspecified order",
    "return-type": "a missing return value, or a superfluous one",
    "shift-count-overflow": "a shift by more bits than the type has",
    "sign-compare": "a negative constant is compared with an unsigned number",
    "sizeof-array-argument": "sizeof of an array parameter, which is a pointer",
    "string-compare": "the address of a string literal is compared",
    "unavailable-function": "a call to a library function that always fails, such as fork",
    "uninitialized": "a variable is read before any path assigns it",
    "unused-function": "a static function that is never called",
    "unused-value": "a computed value is not used",
    "unused-variable": "a local variable that is never used",
    # The command line and the run
    "missing-file": "a program did not find a file that exists outside its simulated disk",
    "pointer-order": "an ordering comparison of pointers to different objects, found at run time",
    "sensor-range": "a sensor reading is compared with a value that it cannot reach",
    "silent-run": "a run without --max-time prints nothing for a long time, and may never end",
    "speed-limit": "vm exceeds the robot's maximum speed",
    "stale-state": "a loop waits for State to change without reading the sensors",
    "unconnected": "a robot function is called without a connection",
    "unfinished-move": "another pr, or the end of the program, interrupts a pr",
    "unsaved-files": "files that a program wrote are not saved",
    "unused-program": "a C file that no robot runs",
}
"""The meaning of each warning."""

MINOR: Final = frozenset({
    "implicit-int", "implicit-function-declaration", "macro-redefined", "extra-tokens",
    "unknown-pragmas", "unused-function", "unused-variable",
})  # fmt: skip
"""Warnings of old habits and of tidiness; where few are shown, the others go first."""

_EVERY: Final = frozenset({"all", "everything", "extra", "pedantic"})
_ALIASES: Final = {
    "maybe-uninitialized": "uninitialized",
    "constant-conversion": "overflow",
    "integer-overflow": "overflow",
    "unused-but-set-variable": "unused-variable",
    "undef": "cpp",
}

_CUTOFF: Final = 0.85


@dataclass(frozen=True, slots=True)
class Selection:
    """Which warnings are shown, and which are errors.

    Attributes:
        hidden: names of warnings that are not shown.
        errors: names of warnings that are errors.
        all_errors: all others are errors, too.
        allowed: names that `all_errors` does not hold for.
    """

    hidden: frozenset[str] = frozenset()
    errors: frozenset[str] = frozenset()
    all_errors: bool = False
    allowed: frozenset[str] = field(default=frozenset())

    @classmethod
    def of(cls, options: Iterable[str]) -> Selection:
        """Return the selection of `-W` options, of which later ones count more.

        Args:
            options: what follows each `-W`, such as `no-format`; names that gcc may know are
                accepted without effect.
        """
        made = cls()
        for option in options:
            made = made.changed(option)
        return made

    def changed(self, option: str) -> Selection:
        """Return the selection after one more option."""
        is_on = not option.startswith("no-")
        name = option.removeprefix("no-")
        if name == "error":
            return replace(self, all_errors=is_on, errors=frozenset(), allowed=frozenset())
        if name.startswith("error="):
            names = _named(name.removeprefix("error="))
            return replace(
                self,
                hidden=self.hidden - names if is_on else self.hidden,
                errors=self.errors | names if is_on else self.errors - names,
                allowed=self.allowed - names if is_on else self.allowed | names,
            )
        names = _named(name)
        return replace(self, hidden=self.hidden - names if is_on else self.hidden | names)

    def severity(self, flag: str) -> Literal["warning", "error"] | None:
        """Return how a warning is reported, None if it is not; `flag` is its name."""
        if flag in self.hidden:
            return None
        is_error = flag in self.errors or (self.all_errors and flag not in self.allowed)
        return "error" if is_error else "warning"

    def select(self, messages: Sequence[Diagnostic]) -> list[Diagnostic]:
        """Return the selected messages; notes belong to the message before them."""
        selected: list[Diagnostic] = []
        is_kept = True
        for message in messages:
            if message.severity == "warning":
                severity = self.severity(message.flag)
                is_kept = severity is not None
                if severity is not None:
                    selected.append(replace(message, severity=severity))
                continue
            is_kept = is_kept or message.severity == "error"
            if is_kept:
                selected.append(message)
        return selected


def unknown_option(option: str) -> str | None:
    """Return the name that a `-W` option resembles, if it is unknown and resembles one.

    >>> unknown_option("no-unused-valeu")
    'unused-value'
    >>> unknown_option("shadow") is None
    True
    """
    name = option.removeprefix("no-").removeprefix("error=")
    if name == "error" or _named(name):
        return None
    found = difflib.get_close_matches(name, WARNINGS, n=1, cutoff=_CUTOFF)
    return found[0] if found else None


def _named(name: str) -> frozenset[str]:
    """Return the warnings that a name selects: `unused` is all that start with `unused-`."""
    name = name.partition("=")[0]  # -Wformat=2
    name = _ALIASES.get(name, name)
    if name in _EVERY:
        return frozenset(WARNINGS)
    return frozenset(each for each in WARNINGS if each == name or each.startswith(f"{name}-"))
