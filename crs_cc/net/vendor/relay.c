/* The program of a robot that is driven from outside: posts the requests that arrive on its standard
   input, one after the other, and writes the reply of each to its robot's client. A request is its
   code and the message without the unused bytes of its data; a reply is such a message. */
#include <crs_request.h>
#include <string.h>

#define INPUT 0
#define CLIENT 3
#define HEAD ((int)(sizeof(struct __crs_message) - CRS_DATA_SIZE))

static struct __crs_message posted;
static unsigned char content[sizeof(int) + sizeof(struct __crs_message)];

/* Waits until there is input; returns 0 at its end. */
static int is_waited_for(void)
{
    struct __crs_message message;

    for (;;) {
        message.size = 0;
        if (__crs_request(CRS_INPUT, &message) > 0)
            return 1;
        if (message.f[0] == 0)
            return 0;
        __crs_request(CRS_SLEEP, &message);
    }
}

/* Reads so many bytes; returns 0 if the input ends before. */
static int take(unsigned char *place, int size)
{
    struct __crs_message message;
    int read = 0, part;

    while (read < size) {
        message.i[0] = INPUT;
        message.i[1] = size - read;
        message.size = 0;
        part = __crs_request(CRS_READ, &message);
        if (part <= 0)
            return 0;
        memcpy(place + read, message.data, part);
        read += part;
    }
    return 1;
}

static void give(const unsigned char *place, int size)
{
    struct __crs_message message;
    int written, part;

    for (written = 0; written < size; written += part) {
        part = size - written < CRS_DATA_SIZE ? size - written : CRS_DATA_SIZE;
        message.i[0] = CLIENT;
        message.size = part;
        memcpy(message.data, place + written, part);
        __crs_request(CRS_WRITE, &message);
    }
}

static int is_fitting(int size)
{
    return size >= 0 && size <= CRS_DATA_SIZE;
}

int main(void)
{
    int code;

    while (is_waited_for() && take(content, sizeof code + HEAD)) {
        memcpy(&code, content, sizeof code);
        memcpy(&posted, content + sizeof code, HEAD);
        if (!is_fitting(posted.size) || !take(posted.data, posted.size))
            return 1;
        __crs_request(code, &posted);
        if (!is_fitting(posted.size))
            posted.size = 0;
        give((unsigned char *)&posted, HEAD + posted.size);
    }
    return 0;
}
