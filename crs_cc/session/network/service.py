"""The service of the network: it answers requests, and wakes programs when something arrives."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from typing import TYPE_CHECKING, Any, Final

import numpy as np

from crs_cc.core.arrays import BoolArray, FloatArray
from crs_cc.requests import CODES, DATA_SIZE, REQUESTS
from crs_cc.session.network import operations
from crs_cc.session.network.delivery import NEVER, deliver, next_cycle
from crs_cc.session.network.errors import EINVAL, ENOTCONN, SocketError
from crs_cc.session.network.network import Network
from crs_cc.session.network.sockets import (
    AF_INET,
    DATAGRAM,
    NOWHERE,
    OUTSIDE,
    POLLERR,
    POLLHUP,
    POLLIN,
    POLLOUT,
    Endpoint,
    Key,
    NetworkState,
    Wait,
)

if TYPE_CHECKING:
    from crs_cc.session.host import HostRequest
    from crs_cc.sim.engine.environment import Environment

NETWORK_CODES: Final = frozenset(
    code for code, row in REQUESTS.items() if row.server == "network"
)  # fmt: skip

_RECEIVES, _SENDS = 1, 2  # in the list of `SOCKET_WAIT`


class NetworkService:
    """The network of a session.

    Attributes:
        network: the network.
    """

    def __init__(self, environment: Environment) -> None:
        """Make a network of the robots of an environment."""
        self.network = Network(environment)
        self._environment = environment

    # -- state ---------------------------------------------------------------------------------

    @property
    def is_used(self) -> bool:
        """Whether there is anything that changes with time."""
        state = self.network.state
        return bool(state.sockets or state.segments)

    def snapshot(self) -> NetworkState | None:
        """Return the state; None if no program has used the network."""
        state = self.network.state
        return None if state == NetworkState() else state.copy()

    def restore(self, snapshot: NetworkState | None) -> None:
        """Restore a snapshot."""
        self.network.state = NetworkState() if snapshot is None else snapshot.copy()

    def hashed(self) -> bytes:
        """Return the state as bytes, to be hashed; none if no program has used the network."""
        state = self.network.state
        return b"" if state == NetworkState() else repr(state).encode()

    # -- time ----------------------------------------------------------------------------------

    def next_cycle(self) -> int:
        """Return the first cycle at whose start something can happen; `NEVER` if nothing can."""
        return next_cycle(self.network) if self.is_used else NEVER

    def begin_cycle(self, clock_s: FloatArray, alive: BoolArray) -> None:
        """Deliver what arrives at the start of the current cycle, and wake waiting programs.

        Args:
            clock_s: the programs' clocks, changed in place.
            alive: which programs are running.
        """
        if not self.is_used:
            return
        state, time_s = self.network.state, self._environment.time_s
        for key in sorted(state.sockets):
            if key[0] != OUTSIDE and not alive[key[0]] and key in state.sockets:
                self.network.remove(key, time_s)
        deliver(self.network, self._environment.cycle, time_s)
        for robot, wait in list(state.waits.items()):
            if not alive[robot] or wait.until_s < time_s:
                del state.waits[robot]
            elif self._is_ready(robot, wait.sockets):
                clock_s[robot] = time_s
                del state.waits[robot]

    def _is_ready(self, robot: int, sockets: Sequence[int]) -> bool:
        for each in sockets:
            socket = self.network.state.sockets.get((robot, each // 4))
            wanted = POLLERR | POLLHUP
            wanted |= POLLIN if each & _RECEIVES else 0
            wanted |= POLLOUT if each & _SENDS else 0
            if socket is None or socket.ready & wanted:
                return True
        return False

    # -- requests ------------------------------------------------------------------------------

    def serve(self, code: int, request: HostRequest) -> float:
        """Answer a request in place; return when its program continues [s]."""
        message = request.message
        self.network.state.waits.pop(request.robot, None)
        if code == CODES["SOCKET_WAIT"]:
            return self._wait(request)
        try:
            message["result"] = _SERVERS[code](self.network, request)
        except SocketError as refused:
            message["result"] = -refused.number
        return request.clock_s

    def _wait(self, request: HostRequest) -> float:
        message = request.message
        size, timeout_s = int(message["size"]), float(message["f"][0])
        message["result"] = 0
        sockets = np.frombuffer(_data(message)[: size // 4 * 4], "<i4").tolist()
        if not timeout_s > 0.0 or self._is_ready(request.robot, sockets):
            return request.clock_s
        until_s = request.clock_s + timeout_s
        self.network.state.waits[request.robot] = Wait(tuple(sockets), until_s)
        return until_s


def _data(message: Any) -> bytes:
    size = min(max(int(message["size"]), 0), DATA_SIZE)
    return message["data"][:size].tobytes()  # type: ignore[no-any-return]


def _reply(message: Any, content: bytes) -> int:
    message["size"] = len(content)
    message["data"][: len(content)] = np.frombuffer(content, np.uint8)
    return len(content)


def _key(request: HostRequest) -> Key:
    return request.robot, int(request.message["i"][0])


def _endpoint(request: HostRequest, *, is_local: bool) -> Endpoint:
    """Return the address in a request: a local socket's name, or address and port."""
    if is_local:
        name = _data(request.message)
        if not name:
            raise SocketError(EINVAL)
        return 0, name
    address, port = request.message["i"][1:3].tolist()
    return address & 0xFFFFFFFF, port


def _put_endpoint(message: Any, endpoint: Endpoint) -> None:
    address, port = endpoint
    message["i"][1] = np.uint32(address).view(np.int32)
    message["i"][2], message["size"] = 0, 0
    if isinstance(port, bytes):
        _reply(message, port)
    else:
        message["i"][2] = port


def _is_local(network: Network, request: HostRequest) -> bool:
    return network.socket(_key(request)).family != AF_INET


def _open(network: Network, request: HostRequest) -> int:
    family, kind = request.message["i"][:2].tolist()
    return operations.open_socket(network, request.robot, family, kind)[1]


def _open_pair(network: Network, request: HostRequest) -> int:
    first, second = operations.open_pair(network, request.robot, int(request.message["i"][0]))
    request.message["i"][0] = second[1]
    return first[1]


def _close(network: Network, request: HostRequest) -> int:
    network.socket(_key(request))
    network.remove(_key(request), request.clock_s)
    return 0


def _bind(network: Network, request: HostRequest) -> int:
    network.bind(_key(request), _endpoint(request, is_local=_is_local(network, request)))
    return 0


def _listen(network: Network, request: HostRequest) -> int:
    operations.listen(network, _key(request), int(request.message["i"][1]))
    return 0


def _connect(network: Network, request: HostRequest) -> int:
    to = _endpoint(request, is_local=_is_local(network, request))
    operations.connect(network, _key(request), to, request.clock_s)
    return 0


def _accept(network: Network, request: HostRequest) -> int:
    return operations.accept(network, _key(request))[1]


def _send(network: Network, request: HostRequest) -> int:
    key, message = _key(request), request.message
    content = _data(message)
    is_addressed, has_more = message["i"][3:5].tolist()
    if network.socket(key).kind != DATAGRAM:
        return operations.send(network, key, content, request.clock_s)
    to = _endpoint(request, is_local=False) if is_addressed else None
    return operations.send_datagram(
        network, key, content, to, request.clock_s, has_more=bool(has_more)
    )


def _receive(network: Network, request: HostRequest) -> int:
    message = request.message
    first, count, stays = message["i"][1:4].tolist()
    content, origin, length = operations.receive(
        network, _key(request), first, min(count, DATA_SIZE), stays=bool(stays)
    )
    _put_endpoint(message, origin)
    message["i"][3] = length
    return _reply(message, content)


def _shut(network: Network, request: HostRequest) -> int:
    operations.shut_down(network, _key(request), int(request.message["i"][1]), request.clock_s)
    return 0


def _name(network: Network, request: HostRequest) -> int:
    socket = network.socket(_key(request))
    found = socket.local or NOWHERE
    if request.message["i"][1]:
        if socket.remote is None or socket.condition == "connecting":
            raise SocketError(ENOTCONN)
        found = socket.remote
    _put_endpoint(request.message, found)
    return 0


def _error(network: Network, request: HostRequest) -> int:
    return operations.take_error(network.socket(_key(request)))


def _poll(network: Network, request: HostRequest) -> int:
    return network.socket(_key(request)).ready


def _address_of(network: Network, request: HostRequest) -> int:
    name = _data(request.message).decode("utf-8", "replace")
    found = network.addresses.find(name, request.robot)
    request.message["i"][1] = np.uint32(found or 0).view(np.int32)
    return int(found is not None)


def _name_of(network: Network, request: HostRequest) -> int:
    address = int(request.message["i"][1]) & 0xFFFFFFFF
    name = network.addresses.name(address, request.robot).encode("utf-8", "surrogateescape")
    return _reply(request.message, name[:DATA_SIZE])


def _by_code() -> Iterator[tuple[int, Callable[[Network, HostRequest], int]]]:
    for name, server in {
        "OPEN": _open, "PAIR": _open_pair, "CLOSE": _close, "BIND": _bind, "LISTEN": _listen,
        "CONNECT": _connect, "ACCEPT": _accept, "SEND": _send, "RECEIVE": _receive,
        "SHUTDOWN": _shut, "NAME": _name, "ERROR": _error, "POLL": _poll,
    }.items():  # fmt: skip
        yield CODES[f"SOCKET_{name}"], server
    yield CODES["NETWORK_ADDRESS"], _address_of
    yield CODES["NETWORK_NAME"], _name_of


_SERVERS: Final = dict(_by_code())
