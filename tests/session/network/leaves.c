/* A client that ends without a word. */
#include <netdb.h>
#include <netinet/in.h>
#include <string.h>
#include <sys/socket.h>

int main(int argc, char **argv)
{
    struct sockaddr_in address = {AF_INET, htons(7000), {0}};
    int line = socket(AF_INET, SOCK_STREAM, 0);

    (void)argc;
    memcpy(&address.sin_addr, gethostbyname(argv[1])->h_addr, sizeof address.sin_addr);
    return connect(line, (struct sockaddr *)&address, sizeof address) < 0;
}
