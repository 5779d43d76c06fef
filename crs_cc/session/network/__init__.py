"""The network of a run: sockets of programs, and data in transit between them.

`sockets` has its state as plain records, `addresses` its computers, `network` the operations,
`delivery` what arrives, `outside` what comes from the real network, and `service` the requests.
"""
