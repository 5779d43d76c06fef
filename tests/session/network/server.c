/* A server of commands, a line each, to several clients at a time, by select. */
#include <arpa/inet.h>
#include <errno.h>
#include <netinet/in.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/select.h>
#include <sys/socket.h>
#include <unistd.h>

#define CLIENTS 8

static struct client { int descriptor, filled; char line[256]; } clients[CLIENTS];

static void answer(struct client *client, char *line)
{
    char reply[600];
    long sum = 0;
    char *word;

    if (strncmp(line, "echo ", 5) == 0) {
        snprintf(reply, sizeof reply, "%s\n", line + 5);
    } else if (strncmp(line, "sum ", 4) == 0) {
        for (word = strtok(line + 4, " "); word != NULL; word = strtok(NULL, " "))
            sum += atol(word);
        snprintf(reply, sizeof reply, "%ld\n", sum);
    } else {
        snprintf(reply, sizeof reply, "unknown: %s\n", line);
    }
    send(client->descriptor, reply, strlen(reply), 0);
}

/* Returns whether the client is still there. */
static int serve(struct client *client)
{
    char *end;
    int got = recv(client->descriptor, client->line + client->filled,
                   sizeof client->line - 1 - client->filled, 0);

    if (got <= 0)
        return 0;
    client->filled += got;
    client->line[client->filled] = '\0';
    while ((end = strchr(client->line, '\n')) != NULL) {
        *end++ = '\0';
        answer(client, client->line);
        client->filled -= end - client->line;
        memmove(client->line, end, client->filled + 1);
    }
    return 1;
}

static int listen_at(int port)
{
    struct sockaddr_in address;
    int one = 1, listener = socket(AF_INET, SOCK_STREAM, 0);

    memset(&address, 0, sizeof address);
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_ANY);
    address.sin_port = htons(port);
    setsockopt(listener, SOL_SOCKET, SO_REUSEADDR, &one, sizeof one);
    if (bind(listener, (struct sockaddr *)&address, sizeof address) < 0) {
        perror("bind");
        exit(1);
    }
    listen(listener, 5);
    return listener;
}

/* Serves as many clients as its second argument says, then ends. */
int main(int argc, char **argv)
{
    int listener = listen_at(atoi(argv[1])), left = atoi(argv[2]), top, i;
    fd_set readable;

    (void)argc;
    printf("ready\n");
    fflush(stdout);
    while (left > 0) {
        FD_ZERO(&readable);
        top = listener;
        FD_SET(listener, &readable);
        for (i = 0; i < CLIENTS; i++)
            if (clients[i].descriptor > 0) {
                FD_SET(clients[i].descriptor, &readable);
                top = clients[i].descriptor > top ? clients[i].descriptor : top;
            }
        if (select(top + 1, &readable, NULL, NULL, NULL) < 0)
            return 2;
        for (i = 0; i < CLIENTS; i++)
            if (clients[i].descriptor > 0 && FD_ISSET(clients[i].descriptor, &readable)
                && !serve(&clients[i])) {
                close(clients[i].descriptor);
                clients[i].descriptor = 0;
                left--;
            }
        if (!FD_ISSET(listener, &readable))
            continue;
        for (i = 0; clients[i].descriptor > 0; i++)
            ;
        clients[i].descriptor = accept(listener, NULL, NULL);
        clients[i].filled = 0;
    }
    printf("served\n");
    return 0;
}
