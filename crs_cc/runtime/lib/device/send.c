/* Sending messages. The channel in use is the program's own affair: each message names one. */
#include <crs/device.h>
#include <stddef.h>
#include <string.h>

static int channel_in_use = CRS_RADIO;

static int send_message(int to, int group, int type, const void *data, int size)
{
    struct __crs_message message;

    if (size < 0 || size > CRS_MESSAGE_SIZE || (size > 0 && data == NULL))
        return 0;
    message.i[0] = to;
    message.i[1] = group;
    message.i[2] = type;
    message.i[3] = channel_in_use;
    message.size = size;
    if (size > 0)
        memcpy(message.data, data, size);
    return __crs_post_device(CRS_SEND, &message);
}

int crs_send(int to, int type, const void *data, int size)
{
    return to < 0 ? 0 : send_message(to, -1, type, data, size);
}

int crs_broadcast(int type, const void *data, int size)
{
    return send_message(CRS_ALL, -1, type, data, size);
}

int crs_multicast(int group, int type, const void *data, int size)
{
    return group < 0 ? 0 : send_message(CRS_ALL, group, type, data, size);
}

int crs_use_channel(int channel)
{
    struct __crs_message message;

    if (channel < 0 || !__crs_ask_device(CRS_CHANNEL, &message, channel, 0, 0, 0))
        return 0;
    channel_in_use = channel;
    return 1;
}
