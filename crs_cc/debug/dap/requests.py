"""All requests that are answered, by name."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from crs_cc.debug.dap import (
    evaluation,
    lifecycle,
    looking,
    memory,
    motion,
    sources,
    variables,
    wishes,
)

if TYPE_CHECKING:
    from collections.abc import Mapping

    from crs_cc.debug.dap.server import Handler

HANDLERS: Final[Mapping[str, Handler]] = {
    "initialize": lifecycle.initialize,
    "launch": lifecycle.launch,
    "attach": lifecycle.attach,
    "configurationDone": lifecycle.configuration_done,
    "restart": lifecycle.restart,
    "terminate": lifecycle.terminate,
    "disconnect": lifecycle.disconnect,
    "continue": motion.continue_,
    "reverseContinue": motion.reverse_continue,
    "next": motion.next_,
    "stepIn": motion.step_in,
    "stepOut": motion.step_out,
    "stepBack": motion.step_back,
    "pause": motion.pause,
    "gotoTargets": motion.goto_targets,
    "goto": motion.goto,
    "restartFrame": motion.restart_frame,
    "setBreakpoints": wishes.set_breakpoints,
    "setFunctionBreakpoints": wishes.set_function_breakpoints,
    "dataBreakpointInfo": wishes.data_breakpoint_info,
    "setDataBreakpoints": wishes.set_data_breakpoints,
    "setExceptionBreakpoints": wishes.set_exception_breakpoints,
    "threads": looking.threads,
    "stackTrace": looking.stack_trace,
    "scopes": looking.scopes,
    "variables": variables.variables,
    "exceptionInfo": looking.exception_info,
    "evaluate": evaluation.evaluate,
    "setVariable": evaluation.set_variable,
    "setExpression": evaluation.set_expression,
    "completions": evaluation.completions,
    "readMemory": memory.read_memory,
    "writeMemory": memory.write_memory,
    "loadedSources": sources.loaded_sources,
    "source": sources.source,
    "disassemble": sources.disassemble,
}
