/* The firing order of sensors, as both dialects send it. */
#include <crs/order.h>
#include <stddef.h>

#define END 255
#define MOST 16

void __crs_put_order(struct __crs_message *message, const int *order)
{
    int size = 0;

    while (order != NULL && size < MOST && (order[size] & 255) != END) {
        message->data[size] = order[size];
        size++;
    }
    message->size = size;
}
