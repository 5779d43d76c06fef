/* Services and protocols by name and number (POSIX netdb.h), as in /etc/services and
   /etc/protocols. */
#include <byteswap.h>
#include <netdb.h>
#include <string.h>

#include <crs/names.h>

static char *aliases[] = {NULL};
static const struct { const char *name; int port; } services[] = {
    {"echo", 7}, {"discard", 9}, {"systat", 11}, {"daytime", 13}, {"netstat", 15}, {"qotd", 17},
    {"chargen", 19}, {"ftp-data", 20}, {"ftp", 21}, {"ssh", 22}, {"telnet", 23}, {"smtp", 25},
    {"time", 37}, {"domain", 53}, {"tftp", 69}, {"finger", 79}, {"http", 80}, {"pop3", 110},
    {"ntp", 123}, {"imap2", 143}, {"https", 443},
};
static const struct { const char *name; int number; } protocols[] = {
    {"ip", 0}, {"icmp", 1}, {"tcp", 6}, {"udp", 17},
};
static struct servent service;
static struct protoent protocol;

int __crs_port_of(const char *name)
{
    unsigned i;

    for (i = 0; i < sizeof services / sizeof *services; i++)
        if (strcmp(services[i].name, name) == 0)
            return services[i].port;
    return -1;
}

const char *__crs_service_at(int port)
{
    unsigned i;

    for (i = 0; i < sizeof services / sizeof *services; i++)
        if (services[i].port == port)
            return services[i].name;
    return NULL;
}

static struct servent *found_service(const char *name, int port, const char *wanted)
{
    if (name == NULL || port < 0)
        return NULL;
    service.s_name = (char *)name;
    service.s_aliases = aliases;
    service.s_port = bswap_16(port);
    service.s_proto = wanted != NULL && strcmp(wanted, "udp") == 0 ? "udp" : "tcp";
    return &service;
}

struct servent *getservbyname(const char *name, const char *wanted)
{
    return found_service(name, __crs_port_of(name), wanted);
}

struct servent *getservbyport(int port, const char *wanted)
{
    return found_service(__crs_service_at(bswap_16(port)), bswap_16(port), wanted);
}

static struct protoent *found_protocol(unsigned i)
{
    protocol.p_name = (char *)protocols[i].name;
    protocol.p_aliases = aliases;
    protocol.p_proto = protocols[i].number;
    return &protocol;
}

struct protoent *getprotobyname(const char *name)
{
    unsigned i;

    for (i = 0; i < sizeof protocols / sizeof *protocols; i++)
        if (strcmp(protocols[i].name, name) == 0)
            return found_protocol(i);
    return NULL;
}

struct protoent *getprotobynumber(int number)
{
    unsigned i;

    for (i = 0; i < sizeof protocols / sizeof *protocols; i++)
        if (protocols[i].number == number)
            return found_protocol(i);
    return NULL;
}
