/* Names of hosts and services (POSIX netdb.h): none is known. */
#include <netdb.h>
#include <stddef.h>
#include <stdio.h>

#include <errno.h>

#include <crs/refuse.h>

int __crs_host_error;

struct hostent *gethostbyname(const char *name)
{
    static int said;

    (void)name;
    __crs_refuse(&said, "gethostbyname", ENETUNREACH);
    h_errno = HOST_NOT_FOUND;
    return NULL;
}

struct hostent *gethostbyaddr(const void *address, socklen_t size, int family)
{
    static int said;

    (void)address;
    (void)size;
    (void)family;
    __crs_refuse(&said, "gethostbyaddr", ENETUNREACH);
    h_errno = HOST_NOT_FOUND;
    return NULL;
}

UNAVAILABLE(struct servent *, getservbyname, (const char *name, const char *protocol), NULL, ENOENT)
UNAVAILABLE(struct protoent *, getprotobyname, (const char *name), NULL, ENOENT)
UNAVAILABLE(int, getaddrinfo,
            (const char *name, const char *service, const struct addrinfo *hints,
             struct addrinfo **found), EAI_FAIL, ENETUNREACH)

void freeaddrinfo(struct addrinfo *found)
{
    (void)found;
}

static const char *text_of(int number)
{
    return number == 0 ? "Success" : "Unknown host";
}

const char *gai_strerror(int number)
{
    return text_of(number);
}

const char *hstrerror(int number)
{
    return text_of(number);
}

void herror(const char *text)
{
    if (text != NULL && *text)
        fprintf(stderr, "%s: ", text);
    fprintf(stderr, "%s\n", text_of(h_errno));
}
