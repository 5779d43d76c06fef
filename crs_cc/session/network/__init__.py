"""The network of a run: sockets of programs, and data in transit between them.

`sockets` has its state as plain records, `addresses` who is on it, `network` what programs do,
`delivery` what arrives, `outside` what comes from the real network, and `service` the requests.
"""
