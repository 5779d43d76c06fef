/* A client of server.c: it sends commands, a part of a line at a time, and prints the replies. */
#include <netdb.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/socket.h>
#include <unistd.h>

static const char *const commands[] = {
    "echo hello", "sum 1 2 3 40", "dance", "echo a longer line, which goes in pieces",
};

static int call(const char *host, const char *port)
{
    struct addrinfo hints = {0}, *found;
    int line;

    hints.ai_family = AF_INET;
    hints.ai_socktype = SOCK_STREAM;
    if (getaddrinfo(host, port, &hints, &found) != 0)
        exit(1);
    line = socket(found->ai_family, found->ai_socktype, found->ai_protocol);
    if (connect(line, found->ai_addr, found->ai_addrlen) < 0) {
        perror("connect");
        exit(2);
    }
    freeaddrinfo(found);
    return line;
}

int main(int argc, char **argv)
{
    int line, i, rounds = argc > 3 ? atoi(argv[3]) : 1;
    char reply[300];
    FILE *in;

    line = call(argv[1], argv[2]);
    in = fdopen(dup(line), "r");
    while (rounds-- > 0)
        for (i = 0; i < 4; i++) {
            send(line, commands[i], 3, 0);
            dprintf(line, "%s\n", commands[i] + 3);
            if (fgets(reply, sizeof reply, in) == NULL)
                return 3;
            fputs(reply, stdout);
        }
    fclose(in);
    close(line);
    return 0;
}
