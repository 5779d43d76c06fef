"""All requests that are answered, by name."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from crs_cc.debug.dap import (
    breakpoint_requests,
    evaluation,
    inspection_requests,
    lifecycle,
    memory,
    motion,
    sources,
    variables,
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
    "setBreakpoints": breakpoint_requests.set_breakpoints,
    "setFunctionBreakpoints": breakpoint_requests.set_function_breakpoints,
    "dataBreakpointInfo": breakpoint_requests.data_breakpoint_info,
    "setDataBreakpoints": breakpoint_requests.set_data_breakpoints,
    "setExceptionBreakpoints": breakpoint_requests.set_exception_breakpoints,
    "threads": inspection_requests.threads,
    "stackTrace": inspection_requests.stack_trace,
    "scopes": inspection_requests.scopes,
    "variables": variables.variables,
    "exceptionInfo": inspection_requests.exception_info,
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
