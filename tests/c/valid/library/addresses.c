/* Byte order, internet addresses, options of bits, and names of limits. */
#define _GNU_SOURCE
#include <arpa/inet.h>
#include <byteswap.h>
#include <endian.h>
#include <netinet/in.h>
#include <stdio.h>
#include <string.h>
#include <sys/param.h>
#include <sys/select.h>
#include <sys/time.h>
#include <values.h>

int main(void)
{
    static const char *const texts[] = {
        "127.0.0.1", "255.255.255.255", "1.2.3", "10.1", "16909060", "0x7f.1", "1.2.3.4.5", "256.1.1.1",
        "", "a.b", "1.2.3.4 x", "1.2.3.0400",
    };
    struct timeval early = {5, 900000}, late = {7, 200000}, sum, difference;
    struct in_addr address;
    unsigned char bits[4] = {0, 0, 0, 0};
    char text[INET_ADDRSTRLEN];
    fd_set set;
    size_t i;

    printf("%x %x %x\n", htons(0x1234), (unsigned int)htonl(0x12345678), ntohs(0x50));
    printf("%x %x %llx\n", bswap_16(0x1234), bswap_32(0x12345678), bswap_64(0x123456789abcdefULL));
    printf("%x %x\n", htobe16(1), le32toh(0x12345678));
    for (i = 0; i < sizeof texts / sizeof *texts; i++) {
        address.s_addr = 0;
        printf("%d", inet_aton(texts[i], &address));
        printf(" %s", inet_ntoa(address));
        printf(" %d\n", inet_pton(AF_INET, texts[i], &address));
    }
    printf("%x %s\n", (unsigned int)inet_addr("1.2.3.4"),
           inet_ntop(AF_INET, &address, text, sizeof text));
    timeradd(&early, &late, &sum);
    timersub(&late, &early, &difference);
    printf("%ld.%06ld %ld.%06ld %d\n", (long)sum.tv_sec, (long)sum.tv_usec,
           (long)difference.tv_sec, (long)difference.tv_usec, timercmp(&early, &late, <) != 0);
    FD_ZERO(&set);
    FD_SET(3, &set);
    FD_SET(65, &set);
    FD_CLR(3, &set);
    printf("%d %d\n", FD_ISSET(3, &set) != 0, FD_ISSET(65, &set) != 0);
    setbit(bits, 11);
    printf("%d %d %d %d\n", bits[1], isset(bits, 11) != 0, roundup(10, 4), howmany(10, 4));
    printf("%d %d %g\n", MAXINT, MIN(3, 2), MAXFLOAT);
    return 0;
}
