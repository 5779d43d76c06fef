"""The debugger in editors: a server of the Debug Adapter Protocol over the engine.

`framing` cuts the stream into messages, `arguments` checks what a request says, `inbox` keeps
requests until their turn comes, `adapter` answers them; the other files are what it answers with.
`serve` is the way in.

The protocol: https://microsoft.github.io/debug-adapter-protocol/specification, version 1.68.
"""
