"""The handlers of all requests, by name."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final

from crs_cc.debug.dap import (
    breakpoint_requests,
    evaluation_requests,
    execution_requests,
    inspection_requests,
    memory,
    session_requests,
    source_requests,
    variables,
)
from crs_cc.debug.dap.server import Handler

HANDLERS: Final[Mapping[str, Handler]] = {
    "initialize": session_requests.initialize,
    "launch": session_requests.launch,
    "attach": session_requests.attach,
    "configurationDone": session_requests.configuration_done,
    "restart": session_requests.restart,
    "terminate": session_requests.terminate,
    "disconnect": session_requests.disconnect,
    "continue": execution_requests.continue_,
    "reverseContinue": execution_requests.reverse_continue,
    "next": execution_requests.next_,
    "stepIn": execution_requests.step_in,
    "stepInTargets": execution_requests.step_in_targets,
    "stepOut": execution_requests.step_out,
    "stepBack": execution_requests.step_back,
    "cancel": execution_requests.cancel,
    "pause": execution_requests.pause,
    "gotoTargets": execution_requests.goto_targets,
    "goto": execution_requests.goto,
    "restartFrame": execution_requests.restart_frame,
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
    "evaluate": evaluation_requests.evaluate,
    "setVariable": evaluation_requests.set_variable,
    "setExpression": evaluation_requests.set_expression,
    "completions": evaluation_requests.completions,
    "readMemory": memory.read_memory,
    "writeMemory": memory.write_memory,
    "loadedSources": source_requests.loaded_sources,
    "source": source_requests.source,
    "disassemble": source_requests.disassemble,
}
