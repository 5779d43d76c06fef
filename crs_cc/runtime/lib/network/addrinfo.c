/* Addresses of names and services, and back (POSIX netdb.h). */
#include <byteswap.h>
#include <netdb.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <crs/names.h>

struct answer {
    struct addrinfo info;
    struct sockaddr_in address;
};

/* Finds a port; returns -1 if there is none of this name. */
static int port_of(const char *service, const struct addrinfo *hints)
{
    char *end;
    long port;

    if (service == NULL)
        return 0;
    port = strtol(service, &end, 10);
    if (*service != '\0' && *end == '\0')
        return port >= 0 && port <= 0xffff ? (int)port : -1;
    if (hints->ai_flags & AI_NUMERICSERV)
        return -1;
    return __crs_port_of(service);
}

static int find_address(const char *name, const struct addrinfo *hints, struct in_addr *address)
{
    if (name == NULL) {
        address->s_addr = bswap_32(hints->ai_flags & AI_PASSIVE ? INADDR_ANY : INADDR_LOOPBACK);
        return 0;
    }
    if (__crs_read_address(name, 0, &address->s_addr))
        return 0;
    if (hints->ai_flags & AI_NUMERICHOST || !__crs_look_up(name, address))
        return EAI_NONAME;
    return 0;
}

static struct addrinfo *make_answer(int type, struct in_addr address, int port,
                                    const char *canonical)
{
    struct answer *made = calloc(1, sizeof *made);

    if (made == NULL)
        return NULL;
    made->address.sin_family = made->info.ai_family = AF_INET;
    made->address.sin_port = bswap_16(port);
    made->address.sin_addr = address;
    made->info.ai_socktype = type;
    made->info.ai_protocol = type == SOCK_STREAM ? IPPROTO_TCP : IPPROTO_UDP;
    made->info.ai_addrlen = sizeof made->address;
    made->info.ai_addr = (struct sockaddr *)&made->address;
    if (canonical == NULL)
        return &made->info;
    made->info.ai_canonname = malloc(strlen(canonical) + 1);
    if (made->info.ai_canonname == NULL) {
        free(made);
        return NULL;
    }
    strcpy(made->info.ai_canonname, canonical);
    return &made->info;
}

/* There is an answer for each type of socket, streams first. */
int getaddrinfo(const char *name, const char *service, const struct addrinfo *hints,
                struct addrinfo **found)
{
    static const struct addrinfo none;
    static const int types[] = {SOCK_STREAM, SOCK_DGRAM};
    struct in_addr address;
    int port, error, i;

    hints = hints == NULL ? &none : hints;
    if (hints->ai_family != AF_UNSPEC && hints->ai_family != AF_INET)
        return EAI_FAMILY;
    if (name == NULL && service == NULL)
        return EAI_NONAME;
    if (hints->ai_socktype < 0 || hints->ai_socktype > SOCK_DGRAM)
        return EAI_SOCKTYPE;
    if ((error = find_address(name, hints, &address)) != 0)
        return error;
    if ((port = port_of(service, hints)) < 0)
        return EAI_SERVICE;
    *found = NULL;
    for (i = 0; i < 2; i++) {
        if (hints->ai_socktype != 0 && hints->ai_socktype != types[i])
            continue;
        *found = make_answer(types[i], address, port,
                             hints->ai_flags & AI_CANONNAME && *found == NULL ? name : NULL);
        if (*found == NULL)
            return EAI_MEMORY;
        found = &(*found)->ai_next;
    }
    return 0;
}

void freeaddrinfo(struct addrinfo *found)
{
    struct addrinfo *next;

    for (; found != NULL; found = next) {
        next = found->ai_next;
        free(found->ai_canonname);
        free(found);
    }
}

const char *gai_strerror(int number)
{
    switch (number) {
    case EAI_BADFLAGS:
        return "Bad value for ai_flags";
    case EAI_NONAME:
        return "Name or service not known";
    case EAI_FAIL:
        return "Non-recoverable failure in name resolution";
    case EAI_FAMILY:
        return "ai_family not supported";
    case EAI_SOCKTYPE:
        return "ai_socktype not supported";
    case EAI_SERVICE:
        return "Servname not supported for ai_socktype";
    case EAI_MEMORY:
        return "Memory allocation failure";
    case EAI_OVERFLOW:
        return "Argument buffer overflow";
    }
    return "Unknown error";
}

static int put_text(char *to, socklen_t room, const char *text)
{
    if (to == NULL || room == 0)
        return 0;
    if (strlen(text) >= room)
        return EAI_OVERFLOW;
    strcpy(to, text);
    return 0;
}

int getnameinfo(const struct sockaddr *address, socklen_t size, char *name, socklen_t name_size,
                char *service, socklen_t service_size, int flags)
{
    const struct sockaddr_in *internet = (const struct sockaddr_in *)address;
    const char *known = NULL;
    char text[256], number[8];

    if (address->sa_family != AF_INET || size < sizeof *internet)
        return EAI_FAMILY;
    if (flags & NI_NUMERICHOST || !__crs_name_of(internet->sin_addr, text)) {
        if (flags & NI_NAMEREQD)
            return EAI_NONAME;
        __crs_write_address(internet->sin_addr.s_addr, text);
    }
    if (put_text(name, name_size, text) != 0)
        return EAI_OVERFLOW;
    sprintf(number, "%u", bswap_16(internet->sin_port));
    if (!(flags & NI_NUMERICSERV))
        known = __crs_service_at(bswap_16(internet->sin_port));
    return put_text(service, service_size, known == NULL ? number : known);
}
