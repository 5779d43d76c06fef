"""The vendor's protocols: programs linked with the vendor's client libraries control robots.

`nserver_packets` and `line_packets` are the two protocols' framing, as pure functions from bytes to
packets and back. `nserver` and `line_robot` answer packets by `exchange`s: requests to the robot
and their replies. Each robot that is driven from outside runs `relay.c`, which gets the requests on
its standard input and posts them; so they are recorded, replayed and undone like typed input.
`switchboard` joins relays with clients, `server` is the clients' sockets.
"""
