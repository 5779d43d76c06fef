/* Answers one client on port 7000 with what it says. */
#include <netinet/in.h>
#include <stdio.h>
#include <sys/socket.h>
#include <unistd.h>

int main(void)
{
    struct sockaddr_in address = {.sin_family = AF_INET, .sin_port = htons(7000)};
    char text[64];
    int got, client, listener = socket(AF_INET, SOCK_STREAM, 0);

    bind(listener, (struct sockaddr *)&address, sizeof address);
    listen(listener, 1);
    client = accept(listener, 0, 0);
    while ((got = recv(client, text, sizeof text, 0)) > 0) {
        printf("%.*s\n", got, text);
        send(client, text, got, 0);
    }
    close(client);
    return 0;
}
