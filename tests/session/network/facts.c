/* What sockets do, as told by one program on one computer. gcc prints the same. */
#include <arpa/inet.h>
#include <errno.h>
#include <fcntl.h>
#include <netdb.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/ioctl.h>
#include <sys/select.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/time.h>
#include <sys/un.h>
#include <unistd.h>

#define SHOW(expression) show(#expression, (long)(expression))

static char bytes[20000];
static int pipes;

static void show(const char *text, long result)
{
    printf("%s = %ld", text, result);
    if (result < 0)
        printf(" (%s)", strerror(errno));
    printf("\n");
    errno = 0;
}

static void settle(void)
{
    usleep(30000);
}

static void on_pipe(int signal)
{
    pipes += signal == SIGPIPE;
}

static void on_alarm(int signal)
{
    (void)signal;
}

static struct sockaddr_in here(int port)
{
    struct sockaddr_in address;

    memset(&address, 0, sizeof address);
    address.sin_family = AF_INET;
    address.sin_port = htons(port);
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    return address;
}

static int bound(int type, struct sockaddr_in *address)
{
    int made = socket(AF_INET, type, 0);
    socklen_t size = sizeof *address;

    *address = here(0);
    if (made < 0 || bind(made, (struct sockaddr *)address, size) < 0
        || getsockname(made, (struct sockaddr *)address, &size) < 0)
        exit(2);
    return made;
}

static int connected(int listener, const struct sockaddr_in *address, int *accepted)
{
    int made = socket(AF_INET, SOCK_STREAM, 0);

    if (connect(made, (const struct sockaddr *)address, sizeof *address) < 0)
        exit(3);
    *accepted = accept(listener, NULL, NULL);
    return made;
}

static int ready(int descriptor, int events)
{
    struct pollfd one = {0};

    one.fd = descriptor;
    one.events = events;
    return poll(&one, 1, 0) < 0 ? -1 : one.revents;
}

static void refusals(void)
{
    struct sockaddr_in address, other;
    int listener = bound(SOCK_STREAM, &address), second = socket(AF_INET, SOCK_STREAM, 0);
    int closed = bound(SOCK_STREAM, &other);

    SHOW(socket(77, SOCK_STREAM, 0));
    SHOW(socket(AF_INET, SOCK_STREAM, IPPROTO_UDP));
    SHOW(bind(0, (struct sockaddr *)&address, sizeof address));
    SHOW(bind(63, (struct sockaddr *)&address, sizeof address));
    SHOW(bind(second, (struct sockaddr *)&address, 4));
    SHOW(bind(second, (struct sockaddr *)&address, sizeof address));
    SHOW(bind(listener, (struct sockaddr *)&other, sizeof other));
    other.sin_addr.s_addr = inet_addr("8.8.8.8");
    SHOW(bind(second, (struct sockaddr *)&other, sizeof other));
    SHOW(accept(second, NULL, NULL));
    SHOW(getpeername(second, (struct sockaddr *)&other, &(socklen_t){sizeof other}));
    SHOW(shutdown(second, SHUT_WR));
    SHOW(recv(second, bytes, 10, 0));
    other = here(ntohs(other.sin_port));
    close(closed);
    SHOW(connect(second, (struct sockaddr *)&other, sizeof other));
    SHOW(listen(listener, 3));
    SHOW(connect(second, (struct sockaddr *)&address, sizeof address));
    SHOW(connect(second, (struct sockaddr *)&address, sizeof address));
    SHOW(lseek(second, 0, SEEK_SET));
    SHOW(setsockopt(second, SOL_SOCKET, 999, bytes, 4));
    SHOW(close(second));
    SHOW(close(second));
    close(listener);
}

static void streams(void)
{
    struct sockaddr_in address, peer, own;
    struct stat status;
    socklen_t size = sizeof peer;
    int listener = bound(SOCK_STREAM, &address), client, server, count, copy;
    FILE *stream;
    char line[40];

    listen(listener, 5);
    SHOW(ready(listener, POLLIN));
    client = connected(listener, &address, &server);
    getsockname(client, (struct sockaddr *)&own, &size);
    SHOW(getpeername(server, (struct sockaddr *)&peer, &size));
    SHOW(own.sin_port == peer.sin_port && own.sin_addr.s_addr == peer.sin_addr.s_addr);
    SHOW(ready(client, POLLIN | POLLOUT));
    SHOW(send(client, "hello, world\nsecond line\n", 25, 0));
    settle();
    SHOW(ready(server, POLLIN | POLLOUT));
    SHOW(ioctl(server, FIONREAD, &count) == 0 ? count : -1);
    SHOW(recv(server, bytes, 5, MSG_PEEK));
    SHOW(recv(server, bytes, 7, 0));
    printf("%.7s\n", bytes);
    copy = dup(server);
    stream = fdopen(copy, "r");
    while (fgets(line, sizeof line, stream) != NULL && strchr(line, '2') == NULL) {
        printf("line: %s", line);
        if (line[0] == 's')
            break;
    }
    fclose(stream);
    SHOW(recv(server, bytes, 10, MSG_DONTWAIT));
    SHOW(fcntl(server, F_SETFL, O_NONBLOCK));
    SHOW(read(server, bytes, 10));
    SHOW(fcntl(server, F_SETFL, 0));
    memset(bytes, 'a', sizeof bytes);
    SHOW(write(client, bytes, 3000));
    SHOW(recv(server, bytes, 3000, MSG_WAITALL));
    SHOW(shutdown(client, SHUT_WR));
    SHOW(send(client, "x", 1, MSG_NOSIGNAL));
    SHOW(recv(server, bytes, 10, 0));
    SHOW(ready(server, POLLIN | POLLOUT));
    SHOW(send(server, "still", 5, 0));
    SHOW(recv(client, bytes, sizeof bytes, 0));
    SHOW(fstat(server, &status) == 0 && (status.st_mode & S_IFMT) == S_IFSOCK);
    SHOW(close(server));
    settle();
    SHOW(recv(client, bytes, 10, 0));
    SHOW(close(client));
    close(listener);
}

static void broken(void)
{
    struct sockaddr_in address;
    int listener = bound(SOCK_STREAM, &address), client, server;
    socklen_t size = sizeof server;

    listen(listener, 5);
    signal(SIGPIPE, on_pipe);
    client = connected(listener, &address, &server);
    close(server);
    settle();
    SHOW(send(client, "lost", 4, 0));
    settle();
    SHOW(send(client, "lost", 4, 0));
    SHOW(send(client, "lost", 4, 0));
    SHOW(pipes > 0);
    close(client);
    client = connected(listener, &address, &server);
    send(client, "unread", 6, 0);
    settle();
    close(server);
    settle();
    SHOW(ready(client, POLLIN));
    SHOW(getsockopt(client, SOL_SOCKET, SO_ERROR, &server, &size) == 0 ? server : -1);
    SHOW(getsockopt(client, SOL_SOCKET, SO_ERROR, &server, &size) == 0 ? server : -1);
    SHOW(recv(client, bytes, 4, 0));
    close(client);
    close(listener);
}

static void waiting(void)
{
    struct sockaddr_in address;
    struct timeval time = {0, 20000}, none = {0, 0};
    struct sigaction action;
    int listener = bound(SOCK_STREAM, &address), client, server = -1, top;
    fd_set readable, writable;

    listen(listener, 5);
    client = socket(AF_INET, SOCK_STREAM, 0);
    fcntl(client, F_SETFL, O_NONBLOCK);
    if (connect(client, (struct sockaddr *)&address, sizeof address) < 0 && errno != EINPROGRESS)
        exit(4);
    FD_ZERO(&writable);
    FD_SET(client, &writable);
    SHOW(select(client + 1, NULL, &writable, NULL, NULL));
    SHOW(connect(client, (struct sockaddr *)&address, sizeof address));
    SHOW(connect(client, (struct sockaddr *)&address, sizeof address));
    server = accept(listener, NULL, NULL);
    FD_ZERO(&readable);
    FD_SET(server, &readable);
    FD_SET(listener, &readable);
    top = (server > listener ? server : listener) + 1;
    SHOW(select(top, &readable, NULL, NULL, &time));
    FD_SET(server, &readable);
    FD_SET(listener, &readable);
    send(client, "go", 2, 0);
    SHOW(select(top, &readable, NULL, NULL, NULL));
    SHOW(FD_ISSET(server, &readable) && !FD_ISSET(listener, &readable));
    SHOW(recv(server, bytes, 2, 0));
    time.tv_usec = 10000;
    SHOW(setsockopt(server, SOL_SOCKET, SO_RCVTIMEO, &time, sizeof time));
    SHOW(recv(server, bytes, 2, 0));
    SHOW(setsockopt(server, SOL_SOCKET, SO_RCVTIMEO, &none, sizeof none));
    memset(&action, 0, sizeof action);
    action.sa_handler = on_alarm;
    sigaction(SIGALRM, &action, NULL);
    ualarm(20000, 0);
    SHOW(recv(server, bytes, 2, 0));
    ualarm(20000, 0);
    FD_ZERO(&readable);
    FD_SET(server, &readable);
    SHOW(select(top, &readable, NULL, NULL, NULL));
    close(server);
    close(client);
    close(listener);
}

static void datagrams(void)
{
    struct sockaddr_in address, other, from;
    socklen_t size = sizeof from;
    struct iovec pieces[2] = {{bytes, 3}, {bytes + 100, 400}};
    struct msghdr message;
    int first = bound(SOCK_DGRAM, &address), second = bound(SOCK_DGRAM, &other), closed;

    memset(bytes, 'b', sizeof bytes);
    SHOW(send(first, "x", 1, 0));
    SHOW(sendto(first, "ping", 4, 0, (struct sockaddr *)&other, sizeof other));
    SHOW(sendto(first, "", 0, 0, (struct sockaddr *)&other, sizeof other));
    SHOW(sendto(first, bytes, 1000, 0, (struct sockaddr *)&other, sizeof other));
    SHOW(sendto(first, bytes, 1000, 0, (struct sockaddr *)&other, sizeof other));
    settle();
    SHOW(recvfrom(second, bytes, 2, 0, (struct sockaddr *)&from, &size));
    SHOW(from.sin_port == address.sin_port && size == sizeof from);
    SHOW(recv(second, bytes, sizeof bytes, 0));
    SHOW(sendto(first, "short", 5, 0, (struct sockaddr *)&other, sizeof other));
    SHOW(recv(second, bytes, sizeof bytes, MSG_PEEK));
    SHOW(recv(second, bytes, sizeof bytes, 0));
    memset(&message, 0, sizeof message);
    message.msg_iov = pieces;
    message.msg_iovlen = 2;
    SHOW(recvmsg(second, &message, 0));
    SHOW(recv(second, bytes, 100, 0));
    SHOW(recv(second, bytes, sizeof bytes, MSG_DONTWAIT));
    SHOW(connect(second, (struct sockaddr *)&address, sizeof address));
    message.msg_iovlen = 2;
    SHOW(sendmsg(second, &message, 0));
    SHOW(recv(first, bytes, sizeof bytes, 0));
    SHOW(ready(first, POLLIN | POLLOUT));
    closed = bound(SOCK_DGRAM, &other);
    close(closed);
    SHOW(connect(second, (struct sockaddr *)&other, sizeof other));
    SHOW(send(second, "nobody", 6, 0));
    settle();
    SHOW(recv(second, bytes, 4, 0));
    SHOW(listen(second, 1));
    close(first);
    close(second);
}

static void local(void)
{
    struct sockaddr_un name = {AF_UNIX, "socket-of-facts"};
    int pair[2], listener = socket(AF_UNIX, SOCK_STREAM, 0), client, server;

    SHOW(socketpair(AF_INET, SOCK_STREAM, 0, pair));
    SHOW(socketpair(AF_UNIX, SOCK_STREAM, 0, pair));
    SHOW(write(pair[0], "abc", 3));
    SHOW(read(pair[1], bytes, 10));
    close(pair[0]);
    SHOW(read(pair[1], bytes, 10));
    close(pair[1]);
    unlink(name.sun_path);
    SHOW(bind(listener, (struct sockaddr *)&name, sizeof name));
    SHOW(listen(listener, 1));
    client = socket(AF_UNIX, SOCK_STREAM, 0);
    SHOW(connect(client, (struct sockaddr *)&name, sizeof name));
    server = accept(listener, NULL, NULL);
    SHOW(send(server, "local", 5, 0));
    SHOW(recv(client, bytes, 10, 0));
    close(client);
    close(server);
    close(listener);
    unlink(name.sun_path);
}

static void names(void)
{
    struct addrinfo hints, *found;
    struct in_addr address;
    char text[40], port[10];
    int one = 1, kind;
    socklen_t size = sizeof kind;
    int made = socket(AF_INET, SOCK_DGRAM, 0);

    SHOW(gethostbyname("127.0.0.1")->h_length);
    SHOW(inet_pton(AF_INET, "1.2.3.4", &address));
    printf("%s %s\n", inet_ntoa(address), inet_ntop(AF_INET, &address, text, sizeof text));
    SHOW(ntohs(getservbyname("daytime", "udp")->s_port));
    SHOW(getprotobyname("tcp")->p_proto);
    memset(&hints, 0, sizeof hints);
    hints.ai_family = AF_INET;
    hints.ai_socktype = SOCK_STREAM;
    hints.ai_flags = AI_PASSIVE;
    SHOW(getaddrinfo(NULL, "echo", &hints, &found));
    SHOW(getnameinfo(found->ai_addr, found->ai_addrlen, text, sizeof text, port, sizeof port,
                     NI_NUMERICHOST | NI_NUMERICSERV));
    printf("%s %s %d\n", text, port, found->ai_next == NULL);
    freeaddrinfo(found);
    hints.ai_flags = AI_NUMERICHOST;
    printf("%s\n", gai_strerror(getaddrinfo("nobody", "7", &hints, &found)));
    SHOW(setsockopt(made, SOL_SOCKET, SO_REUSEADDR, &one, sizeof one));
    SHOW(getsockopt(made, SOL_SOCKET, SO_REUSEADDR, &kind, &size) == 0 ? kind : -1);
    SHOW(getsockopt(made, SOL_SOCKET, SO_TYPE, &kind, &size) == 0 ? kind : -1);
    SHOW(getsockopt(made, IPPROTO_TCP, 99, &kind, &size) < 0 || kind == 0);
    close(made);
}

int main(void)
{
    setvbuf(stdout, NULL, _IOLBF, 0);
    refusals();
    streams();
    broken();
    waiting();
    datagrams();
    local();
    names();
    return 0;
}
