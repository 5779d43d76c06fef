"""The debugger in editors: a server of the Debug Adapter Protocol over the engine.

`framing` splits the stream into messages, `arguments` validates requests, `inbox` queues
them, `server` answers them with the handlers of `request_table`.
`serve` runs one session, on standard streams; `port` serves
those that know its token on a port, which `gate` lets in.

The protocol: https://microsoft.github.io/debug-adapter-protocol/specification, version 1.68.
"""
