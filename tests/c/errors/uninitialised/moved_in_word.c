/* Four bytes are copied to other places in their words: the report names where they come from. */
#include <string.h>

static char packet[20];

static int field(int at)
{
    int value;
    memcpy(&value, packet + at, sizeof value);
    return value > 3; // error: uninitialised read
}

int main(void)
{
    int readings[4], used = 0;
    readings[0] = 1;
    memcpy(packet + 1, readings, sizeof readings);
    used += field(1);
    return used + field(5);
}
