"""The debugger in editors: a server of the Debug Adapter Protocol over the engine.

`framing` splits the stream into messages, `arguments` validates requests, `inbox` queues
them, `server` answers them with the handlers of `request_table`.
`serve` is the entry point.

The protocol: https://microsoft.github.io/debug-adapter-protocol/specification, version 1.68.
"""
