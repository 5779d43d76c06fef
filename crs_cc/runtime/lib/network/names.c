/* Names of computers (POSIX and BSD netdb.h): robots, and what the user has connected. */
#include <byteswap.h>
#include <crs_request.h>
#include <errno.h>
#include <netdb.h>
#include <stdio.h>
#include <string.h>

#include <crs/names.h>

int __crs_host_error;

static struct in_addr found;
static char found_name[CRS_DATA_SIZE + 1];
static char *addresses[] = {(char *)&found, NULL}, *aliases[] = {NULL};
static struct hostent entry = {found_name, aliases, AF_INET, sizeof found, addresses};

int __crs_look_up(const char *name, struct in_addr *address)
{
    struct __crs_message message;
    size_t size = strlen(name);

    if (size > CRS_DATA_SIZE)
        return 0;
    message.i[1] = 0;
    message.size = size;
    memcpy(message.data, name, size);
    if (!__crs_request(CRS_NETWORK_ADDRESS, &message))
        return 0;
    address->s_addr = bswap_32(message.i[1]);
    return 1;
}

int __crs_name_of(struct in_addr address, char *name)
{
    struct __crs_message message;
    int size;

    message.i[1] = bswap_32(address.s_addr);
    size = __crs_request(CRS_NETWORK_NAME, &message);
    memcpy(name, message.data, size);
    name[size] = '\0';
    return size;
}

static struct hostent *not_found(void)
{
    h_errno = HOST_NOT_FOUND;
    return NULL;
}

struct hostent *gethostbyname(const char *name)
{
    if (strlen(name) >= sizeof found_name
        || (!__crs_read_address(name, 0, &found.s_addr) && !__crs_look_up(name, &found)))
        return not_found();
    strcpy(found_name, name);
    return &entry;
}

struct hostent *gethostbyaddr(const void *address, socklen_t size, int family)
{
    if (family != AF_INET || size != sizeof found)
        return not_found();
    memcpy(&found, address, sizeof found);
    return __crs_name_of(found, found_name) ? &entry : not_found();
}

static const char *text_of(int number)
{
    switch (number) {
    case 0:
        return "Resolver Error 0 (no error)";
    case HOST_NOT_FOUND:
        return "Unknown host";
    case TRY_AGAIN:
        return "Host name lookup failure";
    case NO_RECOVERY:
        return "Unknown server error";
    case NO_DATA:
        return "No address associated with name";
    }
    return "Unknown resolver error";
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
