/* Byte order and internet addresses as text (POSIX arpa/inet.h). */
#include <arpa/inet.h>
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>

#include <crs/names.h>

static unsigned int swapped(unsigned int value)
{
    return value >> 24 | (value >> 8 & 0xff00) | (value & 0xff00) << 8 | value << 24;
}

uint16_t htons(uint16_t value)
{
    return value >> 8 | value << 8;
}

uint16_t ntohs(uint16_t value)
{
    return value >> 8 | value << 8;
}

uint32_t htonl(uint32_t value)
{
    return swapped(value);
}

uint32_t ntohl(uint32_t value)
{
    return swapped(value);
}

/* Reads one to four numbers with points between them; the last one fills the bytes that are
   left. */
int __crs_read_address(const char *text, int only_decimal, unsigned int *address)
{
    unsigned int parts[4] = {0, 0, 0, 0}, value = 0;
    int count = 0, i;
    char *end;

    for (;;) {
        if (*text < '0' || *text > '9')
            return 0;
        parts[count++] = strtoul(text, &end, only_decimal ? 10 : 0);
        text = end;
        if (*text != '.' || count == 4)
            break;
        text++;
    }
    if ((*text && *text != ' ' && *text != '\n') || (only_decimal && (count < 4 || *text)))
        return 0;
    for (i = 0; i < count - 1; i++) {
        if (parts[i] > 255)
            return 0;
        value |= parts[i] << (24 - 8 * i);
    }
    if (count > 1 && parts[i] >> (40 - 8 * count) != 0)
        return 0;
    *address = swapped(value | parts[i]);
    return 1;
}

int inet_aton(const char *text, struct in_addr *address)
{
    unsigned int value;

    if (!__crs_read_address(text, 0, &value))
        return 0;
    address->s_addr = value;
    return 1;
}

in_addr_t inet_addr(const char *text)
{
    unsigned int value;

    return __crs_read_address(text, 0, &value) ? value : INADDR_NONE;
}

char *__crs_write_address(unsigned int value, char *text)
{
    sprintf(text, "%u.%u.%u.%u", value & 255, value >> 8 & 255, value >> 16 & 255, value >> 24);
    return text;
}

char *inet_ntoa(struct in_addr address)
{
    static char text[INET_ADDRSTRLEN];

    return __crs_write_address(address.s_addr, text);
}

static int is_known(int family)
{
    if (family == AF_INET)
        return 1;
    errno = EAFNOSUPPORT;
    return 0;
}

int inet_pton(int family, const char *text, void *address)
{
    unsigned int value;

    if (!is_known(family))
        return -1;
    if (!__crs_read_address(text, 1, &value))
        return 0;
    ((struct in_addr *)address)->s_addr = value;
    return 1;
}

const char *inet_ntop(int family, const void *address, char *text, socklen_t size)
{
    if (!is_known(family))
        return NULL;
    if (size < INET_ADDRSTRLEN) {
        errno = ENOSPC;
        return NULL;
    }
    return __crs_write_address(((const struct in_addr *)address)->s_addr, text);
}
