/* Finds who else is there by a broadcast, and measures how long each takes to answer. */
#include <arpa/inet.h>
#include <netdb.h>
#include <stdio.h>
#include <string.h>
#include <sys/socket.h>
#include <sys/time.h>

static double now(void)
{
    struct timeval time;

    gettimeofday(&time, NULL);
    return time.tv_sec % 1000 + time.tv_usec * 1e-6;
}

int main(int argc, char **argv)
{
    int line = socket(AF_INET, SOCK_DGRAM, 0), one = 1, got;
    struct sockaddr_in address = {AF_INET, htons(5000), {htonl(INADDR_ANY)}}, from;
    struct timeval patience = {1, 0};
    socklen_t size = sizeof from;
    char text[40];
    double sent;

    bind(line, (struct sockaddr *)&address, sizeof address);
    if (argc == 1) {                       /* one that answers, once */
        got = recvfrom(line, text, sizeof text, 0, (struct sockaddr *)&from, &size);
        return sendto(line, text, got, 0, (struct sockaddr *)&from, size) == got ? 0 : 1;
    }
    address.sin_addr.s_addr = htonl(INADDR_BROADCAST);
    printf("%d\n", (int)sendto(line, "who", 3, 0, (struct sockaddr *)&address, sizeof address));
    setsockopt(line, SOL_SOCKET, SO_BROADCAST, &one, sizeof one);
    setsockopt(line, SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof patience);
    sent = now();
    sendto(line, "who", 3, 0, (struct sockaddr *)&address, sizeof address);
    while (size = sizeof from,
           (got = recvfrom(line, text, sizeof text, 0, (struct sockaddr *)&from, &size)) > 0) {
        struct hostent *host = gethostbyaddr(&from.sin_addr, sizeof from.sin_addr, AF_INET);
        printf("%s %s %.2f\n", argv[1], host->h_name, now() - sent);
    }
    return 0;
}
