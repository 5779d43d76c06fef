/* Addresses of names and services, and back (POSIX netdb.h). */
#include <arpa/inet.h>
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
    struct servent *entry;
    char *end;
    long port;

    if (service == NULL)
        return 0;
    port = strtol(service, &end, 10);
    if (*service != '\0' && *end == '\0')
        return port >= 0 && port <= 0xffff ? (int)port : -1;
    if (hints->ai_flags & AI_NUMERICSERV)
        return -1;
    entry = getservbyname(service, hints->ai_socktype == SOCK_DGRAM ? "udp" : "tcp");
    return entry == NULL ? -1 : ntohs(entry->s_port);
}

static int find_address(const char *name, const struct addrinfo *hints, struct in_addr *address)
{
    if (name == NULL) {
        address->s_addr = htonl(hints->ai_flags & AI_PASSIVE ? INADDR_ANY : INADDR_LOOPBACK);
        return 0;
    }
    if (inet_aton(name, address))
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
    made->address.sin_port = htons(port);
    made->address.sin_addr = address;
    made->info.ai_socktype = type;
    made->info.ai_protocol = type == SOCK_STREAM ? IPPROTO_TCP : IPPROTO_UDP;
    made->info.ai_addrlen = sizeof made->address;
    made->info.ai_addr = (struct sockaddr *)&made->address;
    if (canonical != NULL && (made->info.ai_canonname = strdup(canonical)) == NULL) {
        free(made);
        return NULL;
    }
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
    return to == NULL || room == 0 || (size_t)snprintf(to, room, "%s", text) < room
               ? 0 : EAI_OVERFLOW;
}

int getnameinfo(const struct sockaddr *address, socklen_t size, char *name, socklen_t name_size,
                char *service, socklen_t service_size, int flags)
{
    const struct sockaddr_in *internet = (const struct sockaddr_in *)address;
    struct servent *entry;
    char text[256], number[8];

    if (address->sa_family != AF_INET || size < sizeof *internet)
        return EAI_FAMILY;
    if (flags & NI_NUMERICHOST || !__crs_name_of(internet->sin_addr, text)) {
        if (flags & NI_NAMEREQD)
            return EAI_NONAME;
        strcpy(text, inet_ntoa(internet->sin_addr));
    }
    if (put_text(name, name_size, text) != 0)
        return EAI_OVERFLOW;
    sprintf(number, "%u", ntohs(internet->sin_port));
    entry = flags & NI_NUMERICSERV
                ? NULL : getservbyport(internet->sin_port, flags & NI_DGRAM ? "udp" : "tcp");
    return put_text(service, service_size, entry == NULL ? number : entry->s_name);
}
